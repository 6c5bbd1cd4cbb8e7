#include <algorithm>

#include "models/treatment/treatment.hpp"

namespace dda {
namespace {

struct ConsistentParameters {
  double alpha = 0.6;
};

/// Consistent (Nitsche) interface: neither locks nor adds compliance.
///
///     q = g + P⁻¹ {σ}n,   {σ}n = w_i σ_i n + w_j σ_j n,   w_i = c_j/(c_i + c_j),  w_j = c_i/(c_i + c_j)
///     k = 2 α c_i c_j/(c_i + c_j)          every assembly is positive definite for α > ½
///
/// c are the trace constants of the blocks (trace_constant.hpp); the weights follow the softer side.
class Consistent final : public Treatment {
 public:
  explicit Consistent(const ConsistentParameters& p) : p_(p) {}

  double stiffness(const SideFaces& side) const override { return p_.alpha * mean_trace(side); }
  double largest_stiffness(const SideFaces& side) const override {
    return std::max(p_.alpha, largest_alpha) * mean_trace(side);
  }
  PointRows rows(const SideFaces& side, const MotionRows& first, const MotionRows& second,
                 const Vec2& p) const override {
    PointRows out = jump_rows(side.normal, first.displacement, second.displacement);
    const Vec2 w = stress_weights(side);
    const auto traction = traction_rows(side.normal);
    out.first_stress = w.x() * traction * side.first.stiffness * first.strain;
    out.second_stress = w.y() * traction * side.second.stiffness * second.strain;
    out.first += p.cwiseInverse().asDiagonal() * out.first_stress;
    out.second += p.cwiseInverse().asDiagonal() * out.second_stress;
    return out;
  }
  Vec2 stress_weights(const SideFaces& side) const override {
    return Vec2(side.second.trace, side.first.trace) / (side.first.trace + side.second.trace);
  }

 private:
  static constexpr double largest_alpha = 4;
  static double mean_trace(const SideFaces& side) {
    return 2 * side.first.trace * side.second.trace / (side.first.trace + side.second.trace);
  }
  ConsistentParameters p_;
};

Schema<ConsistentParameters> schema() {
  using P = ConsistentParameters;
  return Schema<P>(
             "Variationally consistent joint (symmetric interior penalty): no locking, no added compliance.")
      .number(
          "alpha", &P::alpha,
          {.fallback = 0.6,
           .bounds = above(0),
           .text = "Stiffness in units of the blocks' trace constant; above 0.5 every assembly is stable."});
}

}  // namespace

DDA_REGISTER(treatments(), "consistent", schema(), make_of<Consistent>);

}  // namespace dda
