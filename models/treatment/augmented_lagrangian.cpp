#include "models/treatment/spring_joint.hpp"

namespace dda {
namespace {

struct AugmentedLagrangianParameters {
  double factor = 1000;
  double physical_factor = 1e6;
  double contact_factor = 1e4;
};

/// Augmented Lagrangian: a soft spring whose force is carried over into a multiplier until the gap is closed.
///
///     q = g + m,   solve, m ← P⁻¹ t(q; h)/(1 + δ), solve again ... until m stays
///
/// For a bond (δ = 0) that is Λ ← Λ + p_c g, Λ = P m, and no gap is left; for a softening point m ends as its
/// traction. The system keeps its size and its low stiffness p_c; the path's own tangent takes the high one,
/// D̄ = (D⁻¹ − P⁻¹ + P̄⁻¹)⁻¹. A gap shrinks by k_body/(k_body + p_c) in each iteration.
///
/// Bodies that only touch are pressed together by many points, which rigid ones and strong friction can wedge
/// without limit: their springs end at the stiffness p_c + p_t given, δ = p_c/p_t, a compliance of 1e-4 of
/// what the blocks themselves have. Source: Pearce et al. (2000), eqs 7-9; models/README.md.
class AugmentedLagrangian final : public SpringJoint {
 public:
  explicit AugmentedLagrangian(const AugmentedLagrangianParameters& p)
      : SpringJoint(p.factor),
        physical_factor_(std::max(p.factor, p.physical_factor)),
        contact_perturbation_(p.factor / p.contact_factor) {}

  double physical_stiffness(const SideFaces& side) const override { return physical_factor_ * unit(side); }
  Multiplier multiplier() const override { return Multiplier::iterated; }
  double perturbation(bool is_separate) const override { return is_separate ? contact_perturbation_ : 0; }

 protected:
  /// A side shorter than its blocks has little weight against them: without its own scale its gap would close
  /// slowly.
  double unit(const SideFaces& side) const override {
    return spring_unit(side) * std::max(1.0, side.centroid_distance / side.length);
  }

 private:
  double physical_factor_, contact_perturbation_;
};

Schema<AugmentedLagrangianParameters> schema() {
  using P = AugmentedLagrangianParameters;
  return Schema<P>(
             "Springs whose force is carried over into multipliers until no gap is left (see "
             "path.multipliers).")
      .number("factor", &P::factor,
              {.fallback = 1000.0,
               .bounds = above(0),
               .text = "Stiffness p_c of the iteration in units of E/(centroid distance or length of the "
                       "side, the smaller)."})
      .number(
          "physical_factor", &P::physical_factor,
          {.fallback = 1e6,
           .bounds = above(0),
           .text =
               "Stiffness of the joint in the tangent of the path, in the same units; at least `factor`."})
      .number(
          "contact_factor", &P::contact_factor,
          {.fallback = 1e4,
           .bounds = above(0),
           .text = "Stiffness p_t with which joints of bodies that only touch (law `friction`) end beyond "
                   "p_c, in the same units: rigid ones may be wedged by strong friction."});
}

}  // namespace

DDA_REGISTER(treatments(), "augmented_lagrangian", schema(), make_of<AugmentedLagrangian>);

}  // namespace dda
