#pragma once

#include <memory>
#include <string>

#include "meshing/scene/scene.hpp"
#include "models/equilibrium/equilibrium.hpp"
#include "models/parameters.hpp"
#include "support/random.hpp"
#include "support/sample.hpp"

namespace dda {

/// A deck without path and records: what meshing and models need.
struct ModelDeck : ModelParameters {
  Scene scene;
};

inline const Schema<ModelDeck>& model_deck_schema() {
  static const Schema<ModelDeck> schema = [] {
    Schema<ModelDeck> made("A structure and its loads.");
    add_model(made.section("scene", &ModelDeck::scene, scene_schema()));
    return made;
  }();
  return schema;
}

/// The blocks of a deck with their materials, made as the program makes them.
class Structure {
 public:
  explicit Structure(const std::string& yaml, const UnitChange& units = {})
      : deck_(model_deck_schema().read(rescaled(parse_yaml(yaml, "deck.yaml"), model_deck_schema(), units))) {
    assembly_ = std::make_unique<const Assembly>(mesh(deck_.scene));
    std::vector<std::shared_ptr<const Material>> made;
    for (const Region& region : assembly_->regions)
      made.push_back(deck_.material_names.at(region.material).make(deck_.plane));
    body_ = std::make_unique<const Body>(
        Body{*assembly_, deck_.thickness, made, nullptr, second_order_blocks(*assembly_, deck_.kinematics)});
  }

  const ModelDeck& deck() const { return deck_; }
  const Assembly& assembly() const { return *assembly_; }
  const Body& body() const { return *body_; }
  Equilibrium equilibrium() const { return Equilibrium(*body_, deck_); }
  StageLoads no_loads() const {
    StageLoads out;
    out.force.assign(6 * body_->num_nodes(), 0.0);
    return out;
  }
  /// Unknowns of the displacement field u(x) = a + G x: of every block the same field.
  std::vector<double> field(const Vec2& a, const Mat2& g) const {
    std::vector<double> d;
    for (const Block& block : assembly_->blocks) {
      const Vec2 u = a + g * block.moments.centroid;
      d.insert(d.end(), {u.x(), u.y(), (g(1, 0) - g(0, 1)) / 2, g(0, 0), g(1, 1), g(0, 1) + g(1, 0)});
    }
    return d;
  }

 private:
  ModelDeck deck_;
  std::unique_ptr<const Assembly> assembly_;
  std::unique_ptr<const Body> body_;
};

/// A displacement of `d` in other units.
inline std::vector<double> rescaled(std::vector<double> d, const UnitChange& units) {
  for (std::size_t i = 0; i < d.size(); ++i)
    if (i % block_unknowns < 2) d[i] *= units.length;
  return d;
}

/// A unit square in four blocks of two materials, one of them no rectangle, held at the left side; every
/// joint between the materials can crack, the others are bonds. `more` is added below `supports`.
inline std::string square_deck(const std::string& more = "", const std::string& interfaces = "") {
  const std::string softening =
      "  joint: {between: [mortar, stone], law: {type: linear_softening, tensile_strength: 0.01, "
      "fracture_energy: 0.0002, shear_weight: 0.8}}\n";
  const bool has_stages = more.find("stages:") != std::string::npos;
  return R"(
scene:
  regions:
    - {name: a, material: mortar, vertices: [[0, 0], [0.5, 0], [0.6, 0.45], [0, 0.5]]}
    - {name: b, material: stone, vertices: [[0.5, 0], [1, 0], [1, 0.55], [0.6, 0.45]]}
    - {name: c, material: stone, vertices: [[0.6, 0.45], [1, 0.55], [1, 1], [0.4, 1]]}
    - {name: d, material: mortar, vertices: [[0, 0.5], [0.6, 0.45], [0.4, 1], [0, 1]]}
  boundaries:
    left: [[0, 0], [0, 1]]
    right: [[1, 0], [1, 1]]
thickness: 0.7
materials:
  mortar: {type: linear_elastic, young_modulus: 2, poisson_ratio: 0.2}
  stone: {type: linear_elastic, young_modulus: 3, poisson_ratio: 0.3}
interfaces:
)" + (interfaces.empty() ? softening : interfaces) +
         "supports:\n  wall: {boundary: left, fix: xy}\n" + more +
         (has_stages ? ""
                     : "stages:\n  - loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]\n");
}

/// What parameters of loads, gauges and subdivisions need on the unit square.
inline NameHints square_names() {
  return {{"boundary", "right"}, {"of", "wall.x"}, {"support", "wall"},
          {"size", "0.2"},       {"columns", "4"}, {"rows", "3"}};
}

}  // namespace dda
