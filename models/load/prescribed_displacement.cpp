#include "models/body/motion.hpp"
#include "models/body/place_schema.hpp"
#include "models/load/load.hpp"

namespace dda {
namespace {

struct PrescribedDisplacementParameters : Place {
  std::optional<std::string> boundary;
  std::string name;
  Vec2 direction = Vec2::Zero();
  double displacement = 1;
  Position where;
};

/// A point, the mean of a patch of the boundary, or every point of a boundary as by a rigid platen, driven through
/// stiff springs: the stage's factor multiplies the displacement δ of the springs' far ends.
///
///     K += p̄ Tᵀ l lᵀ T,   f += p̄ δ Tᵀ l,   reaction r = p̄ (δ − lᵀ u)
///
/// The spring is there in every stage; before its own it holds the point, and another stage that drives the same goes on from where
/// it has been left. Springs of a platen, two per side, are as
/// stiff as the length that they stand for. Source: Pearce et al. (2000), eqs 16-22.
class PrescribedDisplacement final : public Load {
 public:
  explicit PrescribedDisplacement(PrescribedDisplacementParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    if (p_.direction.norm() == 0) throw InputError(p_.where, "`direction` must not be zero");
    if (p_.boundary)
      add_platen(stage, body);
    else
      stage.driven.push_back(
          {p_.name, displacement_at(body, p_, along(), p_.where), p_.displacement, 1, along(), p_.where});
  }
  std::optional<Action> action() const override {
    if (p_.boundary) return {};
    return Action{p_, p_.displacement * p_.direction};
  }

 private:
  Vec2 along() const { return p_.direction.normalized(); }

  void add_platen(StageLoads& stage, const Body& body) const {
    const auto points = held_points(body, *p_.boundary, p_.where);
    double length = 0;
    for (const BoundaryPoint& point : points) length += point.length;
    for (const BoundaryPoint& point : points) {
      Functional displacement;
      for (const auto& [node, rows] : motions_at(body, point.block, point.x))
        displacement.rows.emplace_back(node, rows.transpose() * along());
      const double share = static_cast<double>(points.size()) * point.length / length;
      stage.driven.push_back({p_.name, std::move(displacement), p_.displacement, share, along(), p_.where});
    }
  }

  PrescribedDisplacementParameters p_;
};

Schema<PrescribedDisplacementParameters> schema() {
  using P = PrescribedDisplacementParameters;
  Schema<P> s(
      "A point, the mean over a patch, or all of a boundary by a rigid platen, driven through stiff springs; "
      "the load "
      "factor multiplies the displacement.");
  declare_place(s);
  return s
      .text(
          "boundary", &P::boundary,
          {.text =
               "Name of a boundary, every point of which is driven alike, as by a rigid platen that does not "
               "turn; instead of `at` or `over`. Its reaction is the sum."})
      .text("name", &P::name,
            {.fallback = "",
             .text = "Name under which its reaction is recorded; without one `driven`, `driven_2` along "
                     "another direction. "
                     "Stages that drive the same place along the same direction move it on or back, under "
                     "one name."})
      .point("direction", &P::direction,
             {.dimension = dimension::none, .text = "Direction (lx, ly), any length."})
      .number("displacement", &P::displacement,
              {.fallback = 1.0, .dimension = dimension::length, .text = "Displacement δ at load factor 1."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (!p.boundary)
          check_place(p, where, findings);
        else if (p.at || p.over || p.inside)
          findings.add(where,
                       "`boundary` names the whole of a boundary: leave out `at`, `over` and `inside`");
      });
}

}  // namespace

DDA_REGISTER(loads(), "prescribed_displacement", schema(), make_of<PrescribedDisplacement>);

}  // namespace dda
