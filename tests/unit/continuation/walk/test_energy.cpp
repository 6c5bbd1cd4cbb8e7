#include <gtest/gtest.h>

#include "continuation/walk/energy.hpp"
#include "support/cracked.hpp"

namespace dda {
namespace {

/// A cubic and its slope.
struct Cubic {
  double a, b, c, e;
  double value(double s) const { return a + s * (b + s * (c + s * e)); }
  double slope(double s) const { return b + s * (2 * c + s * 3 * e); }
};

class ExternalWork : public testing::Test {
 protected:
  State state(double s) const {
    return {Displacements(start_).moved(motion_.value(s), along_), load_.value(s), {}};
  }
  Tangent tangent(double s) const {
    return {Displacements(along_).scaled(motion_.slope(s)), load_.slope(s), true, {}, {}, {}};
  }
  /// ∫ (λ f_ref + f_dead)·d' ds by Simpson's rule.
  double reference(double from, double to) const {
    const Loading& loading = cracked_.system().loading();
    const double live = vec(loading.reference_work).dot(vec(along_)),
                 dead = vec(loading.dead_work).dot(vec(along_));
    const auto power = [&](double s) { return (load_.value(s) * live + dead) * motion_.slope(s); };
    constexpr int steps = 2000;
    const double h = (to - from) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double s = from + i * h;
      sum += h / 6 * (power(s) + 4 * power(s + h / 2) + power(s + h));
    }
    return sum;
  }
  mutable CrackedSystem cracked_{square_deck(R"(stages:
  - name: dead
    loads: [{type: body_force, force: [0.1, -0.3]}]
  - name: live
    loads: [{type: edge_traction, boundary: right, traction: [1, 0.2]}]
)")};
  const std::vector<double> start_ = cracked_.direction(), along_ = cracked_.direction();
  const Cubic load_{0.3, -1, 2, 0.7}, motion_{0, 0.5, -0.3, 1.1};
};

TEST_F(ExternalWork, HermiteIsExactForCubicPaths) {
  const double from = 0.2, to = 1.1;
  const double work =
      external_work(cracked_.system(), {state(from), state(to), tangent(from), tangent(to), to - from});
  EXPECT_NEAR(work / reference(from, to), 1, 1e-11);
}

TEST_F(ExternalWork, WithoutTangentsItIsTheTrapezoid) {
  const State from = state(0.2), to = state(1.1);
  const Loading& loading = cracked_.system().loading();
  const Eigen::VectorXd moved = vec(to.d) - vec(from.d);
  const double expected = (from.load_factor + to.load_factor) / 2 * vec(loading.reference_work).dot(moved) +
                          vec(loading.dead_work).dot(moved);
  EXPECT_NEAR(external_work(cracked_.system(), {from, to, {}, {}}) / expected, 1, 1e-12);
}

}  // namespace
}  // namespace dda
