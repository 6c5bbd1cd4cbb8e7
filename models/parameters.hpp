#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/deck/formula.hpp"
#include "framework/deck/schema.hpp"
#include "models/body/place.hpp"
#include "models/body/random_field.hpp"
#include "models/crack_direction/direction.hpp"
#include "models/gauge/gauge.hpp"
#include "models/interface/law.hpp"
#include "models/kinematics/kinematics.hpp"
#include "models/load/load.hpp"
#include "models/material/material.hpp"
#include "models/treatment/treatment.hpp"

namespace dda {

/// Where the points of a straight side stand: Gauss points, two and beside blocks of second order three; always two; its
/// two ends; its middle.
enum class PointRule { gauss, gauss_2, vertices, midpoint };

/// Water that follows into the cracks of an interface, or is between bodies that only touch.
struct WaterParameters {
  Formula pressure;
  std::optional<double> opening;  ///< at which the pressure is whole; that of rupture when not given [L]
};

/// An entry of `interfaces`: by material pair when `between` is given, between the structure and its mirror image when
/// `boundary` is, else by the name of its curve.
struct InterfaceParameters {
  std::vector<std::string> between;
  std::string boundary;  ///< a plane of symmetry; "": none
  LawChoice law;
  TreatmentChoice treatment;
  std::optional<PointRule> points;  ///< by the treatment when not given
  std::optional<FieldParameters> field;
  std::optional<WaterParameters> water;
  std::optional<Vec2> crack_normal;  ///< of the plane whose projection sides have strength and energy by
  Position where;
};

/// What a support holds.
enum class Fix { x, y, xy, normal, rotation, straight };

/// An entry of `supports`: stiff springs at a point, at the mean of a patch, or along a named boundary.
struct SupportParameters : Place {
  std::optional<std::string> boundary;
  std::optional<Fix> fix;
  std::optional<Vec2> direction;
  std::optional<double> stiffness;
  std::string from;  ///< stage at whose beginning it is put in; "": it is there from the first one on
  Position where;
};

/// Where a crack begins, and which way it sets out.
struct CrackBegin {
  Spot at;
  Vec2 direction = Vec2::Zero();
};

/// An entry of `cracks`: cracks that run through the blocks of some regions.
struct CrackParameters {
  std::vector<std::string> through_blocks;  ///< regions
  std::string law;  ///< interface whose law a crack has; "": that of the region's material with itself
  std::vector<CrackBegin> begin;     ///< where cracks begin; none: wherever stress asks for one
  std::optional<std::int64_t> most;  ///< cracks that begin where stress asks for one
  std::optional<double> apart;       ///< least distance of such a crack to any other [L]
  CrackDirectionChoice direction;
  double shortest_segment = 0.5;    ///< in block sizes
  double stiffness = 100;           ///< k of a cut in units of that of the block's sides
  std::vector<std::string> end_at;  ///< interfaces at which cracks end
  Position where;

  bool is_automatic() const { return begin.empty(); }
};

/// An entry of `stages`; of those with loads every one but the last is brought to its full value and stays.
/// Stages without loads come after it and go on with its loads: they are legs of one path.
struct StageParameters {
  std::string name;
  std::vector<LoadChoice> loads;
  std::map<std::string, double> until;  ///< gauge values that end the leg
  bool unload = false;                  ///< straight to `until`, off the damage surfaces
  Position where;
};

/// The mechanical sections of a deck.
struct ModelParameters {
  double thickness = 1;
  Plane plane = Plane::stress;
  KinematicsChoice kinematics;
  std::map<std::string, MaterialChoice> material_names;
  std::vector<std::pair<std::string, InterfaceParameters>> interfaces;
  std::vector<std::pair<std::string, SupportParameters>> supports;
  std::vector<CrackParameters> cracks;
  std::vector<StageParameters> stages;
  std::vector<std::pair<std::string, GaugeChoice>> gauge_names;
  /// The stages with loads.
  std::vector<StageParameters> loaded_stages() const;
  /// How many of them are applied in full before the path begins: those before the first with `until`, or before the last.
  std::size_t num_dead_stages() const;
  /// Places in `stages` of the others, whose loads the load factor multiplies one after another.
  std::vector<std::size_t> followed_stages() const;
  /// The first of them and the stages after it; none without any.
  std::vector<StageParameters> legs() const;
  double support_stiffness = 1e5;
  double weak_springs = 1e-13;
  Position where;
};

/// Declares thickness, plane, materials, interfaces, supports, stages, gauges of a deck whose struct derives
/// from ModelParameters.
template <class P>
void add_model(Schema<P>& schema);

Kind<InterfaceParameters> interface_kind();
Kind<SupportParameters> support_kind();
Kind<StageParameters> stage_kind();

/// The order of the stages: loads applied in full, then those that are followed and legs, which end by `until`; an unloading
/// leg has one goal.
void check_stages(const std::vector<StageParameters>& stages, Findings& findings);

template <class P>
void add_model(Schema<P>& schema) {
  schema
      .number("thickness", &P::thickness,
              {.dimension = dimension::length, .bounds = above(0), .text = "Thickness."})
      .one_of("plane", &P::plane, {{"stress", Plane::stress}, {"strain", Plane::strain}},
              {.fallback = Plane::stress, .text = "Plane stress or plane strain."})
      .choice("kinematics", &P::kinematics, kinematics(),
              {.fallback = "first_order",
               .text = "How the displacement varies within a block: its strain is constant, or linear."})
      .map("materials", &P::material_names, materials().kind(), {.at_least = 1, .text = "Materials by name."})
      .map("interfaces", &P::interfaces, interface_kind(),
           {.fallback = {{}},
            .text = "Interfaces by the name of their curve, or of a pair of materials (`between`)."})
      .map(
          "supports", &P::supports, support_kind(),
          {.fallback = {{}},
           .text = "Stiff springs that hold the structure; without any only `motion` can say what becomes of "
                   "it."})
      .list(
          "stages", &P::stages, stage_kind(),
          {.fallback = {{}},
           .text = "Loads in their order. Those before the first `until`, or before the last, are applied in "
                   "full and stay; then the loads of each stage are multiplied by a load factor that "
                   "begins at 0, those of the stages before being held as they are. Stages without loads "
                   "go on with the last ones: unloading, loading again. Without any stage there is no "
                   "path, and `motion` begins with the undeformed structure."})
      .map("gauges", &P::gauge_names, gauges().kind(),
           {.fallback = {{}}, .text = "Scalars recorded at every step, by name."})
      .number(
          "support_stiffness", &P::support_stiffness,
          {.fallback = 1e5, .bounds = above(0), .text = "Stiffness of supports in units of E · thickness."})
      .number("weak_springs", &P::weak_springs,
              {.fallback = 1e-13,
               .bounds = at_least(0),
               .text = "Springs that hold every block's centroid, in units of E · thickness."})
      .check([](const P& p, const Position&, Findings& findings) { check_stages(p.stages, findings); });
}

}  // namespace dda
