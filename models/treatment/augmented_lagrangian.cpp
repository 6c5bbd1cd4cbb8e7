#include "models/treatment/spring_joint.hpp"

namespace dda {
namespace {

struct AugmentedLagrangianParameters {
  double factor = 1000;
  double physical_factor = 1e6;
};

/// Augmented Lagrangian: a soft spring whose force is carried over into a multiplier until the gap is closed.
///
///     q = g + m,   solve, m ← P⁻¹ t(q; h), solve again ... until |P⁻¹ t − m| is small
///
/// For a bond or a closed contact that is Λ ← Λ + p_c g, Λ = P m; for a softening point m ends as its
/// traction. The system keeps its size and its low stiffness p_c; the path's own tangent takes the high one,
/// D̄ = (D⁻¹ − P⁻¹ + P̄⁻¹)⁻¹. A gap shrinks by k_body/(k_body + p_c) in each iteration.
/// Source: Pearce et al. (2000), eqs 7-9; models/README.md.
class AugmentedLagrangian final : public SpringJoint {
 public:
  explicit AugmentedLagrangian(const AugmentedLagrangianParameters& p)
      : SpringJoint(p.factor), physical_factor_(std::max(p.factor, p.physical_factor)) {}

  double physical_stiffness(const SideFaces& side) const override { return physical_factor_ * unit(side); }
  Multiplier multiplier() const override { return Multiplier::iterated; }

 protected:
  /// A side shorter than its blocks has little weight against them: without its own scale its gap would close
  /// slowly.
  double unit(const SideFaces& side) const override {
    return spring_unit(side) * std::max(1.0, side.centroid_distance / side.length);
  }

 private:
  double physical_factor_;
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
               "Stiffness of the joint in the tangent of the path, in the same units; at least `factor`."});
}

std::unique_ptr<Treatment> make(const AugmentedLagrangianParameters& p) {
  return std::make_unique<AugmentedLagrangian>(p);
}

}  // namespace

DDA_REGISTER(treatments(), "augmented_lagrangian", schema(), make);

}  // namespace dda
