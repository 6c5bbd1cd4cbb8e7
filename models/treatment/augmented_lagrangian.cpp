#include <algorithm>

#include "models/treatment/treatment.hpp"

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
class AugmentedLagrangian final : public Treatment {
 public:
  explicit AugmentedLagrangian(const AugmentedLagrangianParameters& p) : p_(p) {}

  double stiffness(const SideFaces& side) const override { return p_.factor * unit(side); }
  double largest_stiffness(const SideFaces& side) const override {
    return std::max(p_.factor, largest_factor) * unit(side);
  }
  double physical_stiffness(const SideFaces& side) const override {
    return std::max(p_.factor, p_.physical_factor) * unit(side);
  }
  PointRows rows(const SideFaces& side, const Mat26& first, const Mat26& second, const Vec2&) const override {
    return jump_rows(side.normal, first, second);
  }
  Multiplier multiplier() const override { return Multiplier::iterated; }
  Vec2 stress_weights(const SideFaces&) const override { return Vec2::Zero(); }

 private:
  static constexpr double largest_factor = 1e4;
  /// A side shorter than its blocks has little weight against them: without its own scale its gap would close
  /// slowly.
  static double unit(const SideFaces& side) {
    return spring_unit(side) * std::max(1.0, side.centroid_distance / side.length);
  }
  AugmentedLagrangianParameters p_;
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
