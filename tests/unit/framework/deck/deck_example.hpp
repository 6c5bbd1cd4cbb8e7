#pragma once

#include "framework/deck/family.hpp"

/// A small deck with a parameter of every kind, shared by the tests of schema, family, explain and random
/// decks.
namespace dda::example {

/// A stand-in for what a family makes.
struct Law {
  std::string made;
  double strength = 0;
};

inline Family<Law, double>& laws() {
  static Family<Law, double> family("test_law", "What the interface of a test does.");
  return family;
}

struct Joint {
  Choice<Law, double> law;
  double thickness = 0;
  Position where;
};

inline Schema<Joint> joint_schema() {
  return Schema<Joint>("An interface.")
      .choice("law", &Joint::law, laws(), {.fallback = "bonded", .text = "What the interface does."})
      .number("thickness", &Joint::thickness,
              {.fallback = 1.0, .dimension = dimension::length, .bounds = above(0), .text = "Out of plane."});
}

enum class State { stress, strain };

struct Record {
  int every = 0;
  bool fields = false;
  std::vector<double> stops;
};

inline Schema<Record> record_schema() {
  return Schema<Record>("What is stored.")
      .integer("every", &Record::every,
               {.fallback = 10, .bounds = at_least(1), .text = "Steps between stores."})
      .boolean("fields", &Record::fields, {.fallback = true, .text = "Whether fields are stored."})
      .numbers("stops", &Record::stops,
               {.dimension = dimension::length, .bounds = above(0), .text = "Landings."});
}

struct Deck {
  std::string title;
  double young_modulus = 0, poisson_ratio = 0;
  std::optional<double> density;
  State state = State::stress;
  std::filesystem::path mesh;
  Vec2 origin = Vec2::Zero();
  std::map<std::string, std::vector<Vec2>> curves;
  std::vector<std::string> tags;
  Record record;
  std::vector<std::pair<std::string, Joint>> interfaces;
  std::vector<Choice<Law, double>> layers;
  Node nox;
  Position where;
};

inline void check_layers(const Deck& deck, const Position& where, Findings& findings) {
  if (deck.layers.size() > 3) findings.add(where, "at most three layers");
}

inline Schema<Deck> deck_schema() {
  return Schema<Deck>("The deck of a test.")
      .text("title", &Deck::title, {.fallback = "untitled", .text = "Printed above figures."})
      .number("young_modulus", &Deck::young_modulus,
              {.dimension = dimension::stress, .bounds = above(0), .text = "Stiffness."})
      .number("poisson_ratio", &Deck::poisson_ratio,
              {.fallback = 0.2, .bounds = between(0, 0.5), .text = "Lateral contraction."})
      .number("density", &Deck::density, {.bounds = above(0), .text = "Only for dynamics."})
      .one_of("state", &Deck::state, {{"plane_stress", State::stress}, {"plane_strain", State::strain}},
              {.fallback = State::stress, .text = "Out of plane."})
      .file("mesh", &Deck::mesh, {.fallback = "none.msh", .must_exist = false, .text = "Mesh file."})
      .point("origin", &Deck::origin, {.fallback = Vec2(0, 0), .text = "Of the axes."})
      .map("curves", &Deck::curves, list_of(point_kind(), 2), {.text = "Named polylines."})
      .texts("tags", &Deck::tags, {.text = "Free words."})
      .section("record", &Deck::record, record_schema())
      .map("interfaces", &Deck::interfaces, joint_schema(), {.text = "Interfaces by name."})
      .list("layers", &Deck::layers, laws(), {.text = "Laws in a row."})
      .passthrough("nox", &Deck::nox, {.text = "Handed to the solver as it stands."})
      .check(check_layers);
}

/// A deck that sets everything.
inline const char* full_deck = R"(# a comment
title: "12"
young_modulus: 30000
poisson_ratio: 0.18
density: 2.4e-9
state: plane_strain
mesh: meshes/beam.msh
origin: [1, -2.5]
curves:
  crack: [[0, 0], [0, 10]]
tags: [fine, 'true', "with: colon"]
record: {every: 5, fields: false, stops: [0.1, 0.2]}
interfaces:
  joint:
    law: {type: softening, strength: 3, energy: 0.1}
    thickness: 100
  bed:
    law: bonded
layers:
  - bonded
  - {type: softening, strength: 0.1, energy: 1e-3, exponent: 2}
nox:
  Direction: {Method: Newton}
  Solver Options: [1, two, "3"]
)";

}  // namespace dda::example
