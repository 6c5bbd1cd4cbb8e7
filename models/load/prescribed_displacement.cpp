#include "models/body/place_schema.hpp"
#include "models/load/load.hpp"

namespace dda {
namespace {

struct PrescribedDisplacementParameters : Place {
  std::string name = "driven";
  Vec2 direction = Vec2::Zero();
  double displacement = 1;
  Position where;
};

/// A point, or the mean of a patch of the boundary, driven through a stiff spring: the stage's factor
/// multiplies the displacement δ of the spring's far end.
///
///     K += p̄ Tᵀ l lᵀ T,   f += p̄ δ Tᵀ l,   reaction r = p̄ (δ − lᵀ u)
///
/// The spring is there in every stage; before its own it holds the point. Source: Pearce et al. (2000), eqs
/// 16-22.
class PrescribedDisplacement final : public Load {
 public:
  explicit PrescribedDisplacement(PrescribedDisplacementParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    if (p_.direction.norm() == 0) throw InputError(p_.where, "`direction` must not be zero");
    stage.driven.push_back(
        {p_.name, displacement_at(body, p_, p_.direction.normalized(), p_.where), p_.displacement});
  }
  std::optional<Action> action() const override { return Action{p_, p_.displacement * p_.direction}; }

 private:
  PrescribedDisplacementParameters p_;
};

Schema<PrescribedDisplacementParameters> schema() {
  using P = PrescribedDisplacementParameters;
  Schema<P> s(
      "A point, or the mean over a patch, driven through a stiff spring; the load factor multiplies the "
      "displacement.");
  add_place(s);
  return s
      .text("name", &P::name, {.fallback = "driven", .text = "Name under which its reaction is recorded."})
      .point("direction", &P::direction,
             {.dimension = dimension::none, .text = "Direction (lx, ly), any length."})
      .number("displacement", &P::displacement,
              {.fallback = 1.0, .dimension = dimension::length, .text = "Displacement δ at load factor 1."});
}

}  // namespace

DDA_REGISTER(loads(), "prescribed_displacement", schema(), make_of<PrescribedDisplacement>);

}  // namespace dda
