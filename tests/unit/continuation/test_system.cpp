#include <gtest/gtest.h>

#include "continuation/tangent.hpp"
#include "support/cracked.hpp"

namespace dda {
namespace {

class SystemTest : public testing::TestWithParam<int> {
 protected:
  CrackedSystem cracked_{square_deck(all_loads()), static_cast<std::uint64_t>(GetParam())};
  System& system_ = cracked_.system();
};

/// With frozen damage the laws have the potential ½ t·q: R = ∂/∂d (stored + driven springs' own − f·d).
TEST_P(SystemTest, ResidualIsGradientOfTheEnergy) {
  system_.set_frozen(true);
  const auto energy = [&](const State& at) {
    const Loading& loading = system_.loading();
    double sum = system_.stored(at, system_.laws(at.d, at.load_factor));
    for (const Spring& spring : cracked_.equilibrium().driven_springs())
      sum += 0.5 * spring.stiffness * std::pow(spring.displacement.value(at.d, 0), 2);
    return sum - vec(at.d).dot(vec(loading.dead) + at.load_factor * vec(loading.reference));
  };
  const std::vector<double> residual = cracked_.residual(cracked_.state());
  constexpr double step = 1e-6;
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> along = cracked_.direction();
    const double difference =
        (energy(cracked_.moved(along, step)) - energy(cracked_.moved(along, -step))) / (2 * step);
    EXPECT_NEAR(vec(residual).dot(vec(along)), difference, 1e-8 * vec(residual).norm());
  }
}

TEST_P(SystemTest, TangentIsDifferenceOfTheResidual) {
  const State& at = cracked_.state();
  ASSERT_GT(cracked_.modes().minCoeff(), 0) << "points that load, unload and are closed";
  ASSERT_TRUE(system_.use_tangent(system_.new_stamp(), system_.laws(at.d, at.load_factor).tangent));
  // The stiff supports are 1e5 times the blocks: a difference loses that many digits, so they are taken off.
  constexpr double step = 1e-7;
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> along = cracked_.direction();
    std::vector<double> product(along.size()), intact(along.size(), 0.0);
    system_.linear().multiply(along, product);
    cracked_.equilibrium().intact().multiply_add(along, intact);
    const Eigen::VectorXd difference = (vec(cracked_.residual(cracked_.moved(along, step))) -
                                        vec(cracked_.residual(cracked_.moved(along, -step)))) /
                                       (2 * step);
    const Eigen::VectorXd change = vec(product) - vec(intact), found = difference - vec(intact);
    EXPECT_GT(change.norm(), 1e-3);
    EXPECT_LT((change - found).norm(), 1e-4 * change.norm());
  }
}

TEST_P(SystemTest, LoadDerivativeIsDifferenceOfTheResidual) {
  const State& at = cracked_.state();
  std::vector<double> derivative(at.d.size());
  system_.load_derivative(system_.laws(at.d, at.load_factor), derivative);
  constexpr double step = 1e-5;
  const State above{at.d, at.load_factor + step}, below{at.d, at.load_factor - step};
  const Eigen::VectorXd difference =
      (vec(cracked_.residual(above)) - vec(cracked_.residual(below))) / (2 * step);
  EXPECT_LT((vec(derivative) - difference).norm(), 1e-6 * difference.norm());
}

TEST_P(SystemTest, CommittingLeavesTheResidual) {
  const State& at = cracked_.state();
  const std::vector<double> before = cracked_.residual(at);
  const double dissipated = system_.dissipated(system_.history());
  system_.set_history(system_.next_history(at.d, at.load_factor));
  EXPECT_GT(system_.dissipated(system_.history()), dissipated);
  EXPECT_LT((vec(cracked_.residual(at)) - vec(before)).norm(), 1e-10 * vec(before).norm());
}

TEST_P(SystemTest, ArrivingTangentKeepsTheResidualAndDissipatesOnePerUnit) {
  const State at = cracked_.state();
  system_.set_history(system_.next_history(at.d, at.load_factor));
  const Tangent tangent = arriving_tangent(system_, at);
  ASSERT_FALSE(tangent.d.empty());
  EXPECT_TRUE(tangent.dissipates);
  std::vector<double> change(at.d.size()), per_load(at.d.size());
  system_.linear().multiply(tangent.d, change);
  system_.load_derivative(system_.laws(at.d, at.load_factor), per_load);
  EXPECT_LT((vec(change) + tangent.load_factor * vec(per_load)).norm(), 1e-6 * vec(change).norm());
  double rate = 0;
  for (std::size_t p = 0; p < tangent.opening_rate.size(); ++p) {
    const InterfacePoint& point = cracked_.equilibrium().point(p);
    rate += point.weight * tangent.opening_rate[p] *
            point.law->dissipation_slope(system_.kappa(p, system_.history()[p]), point.stiffness);
  }
  EXPECT_NEAR(rate, 1, 1e-9);
}

TEST_P(SystemTest, NothingThatLeavesUnloads) {
  const State at = cracked_.state();
  system_.set_history(system_.next_history(at.d, at.load_factor));
  const Tangent leaving = leaving_tangent(system_, at, arriving_tangent(system_, at));
  ASSERT_FALSE(leaving.d.empty());
  for (std::size_t p = 0; p < leaving.opening_rate.size(); ++p) {
    if (!system_.history()[p].loading) continue;
    EXPECT_GE(leaving.opening_rate[p], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(States, SystemTest, testing::Range(1, 6));

TEST(System, MetricsAreInnerProducts) {
  CrackedSystem cracked;
  for (const Metric metric : {Metric::natural, Metric::openings}) {
    const std::vector<double> u = cracked.direction(), v = cracked.direction();
    std::vector<double> mu = u, mv = v;
    cracked.system().apply_metric(metric, mu);
    cracked.system().apply_metric(metric, mv);
    EXPECT_NEAR(vec(mu).dot(vec(v)), vec(mv).dot(vec(u)), 1e-13);
    EXPECT_GT(vec(mu).dot(vec(u)), 0);
  }
  const std::vector<double> u = cracked.direction();
  std::vector<double> mu = u, q(2 * cracked.equilibrium().num_crackable());
  cracked.system().apply_metric(Metric::openings, mu);
  cracked.equilibrium().gather(u, q);
  double sum = 0;
  for (std::size_t i = 0; i < q.size(); ++i) sum += cracked.equilibrium().point(i / 2).weight * q[i] * q[i];
  EXPECT_NEAR(vec(mu).dot(vec(u)), sum, 1e-13);
}

}  // namespace
}  // namespace dda
