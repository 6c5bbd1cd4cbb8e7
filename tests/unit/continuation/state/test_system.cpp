#include <gtest/gtest.h>

#include <Eigen/LU>

#include "continuation/walk/tangent.hpp"
#include "support/cracked.hpp"

namespace dda {
namespace {

struct SystemCase {
  std::string treatment, more;  ///< YAML
  std::uint64_t seed;
};

void PrintTo(const SystemCase& at, std::ostream* out) {
  *out << at.treatment << at.more << ", seed " << at.seed;
}

class SystemTest : public testing::TestWithParam<SystemCase> {
 protected:
  /// Random multipliers as large as the openings where some are iterated.
  void SetUp() override {
    std::vector<Vec2> m = system_.multipliers();
    for (Vec2& value : m) value = cracked_.random().point(0.001);
    system_.set_multipliers(m);
  }
  bool is_frictional() const { return !GetParam().more.empty(); }
  /// Cracks grown beyond where they stand: nothing loads.
  void grow_all() {
    const State& at = cracked_.state();
    std::vector<History> grown = system_.next_history(at);
    for (std::size_t p = 0; p < grown.size(); ++p) {
      const InterfacePoint& point = cracked_.equilibrium().point(p);
      grown[p] = point.law->grown(grown[p], point.stiffness, 1.5);
      grown[p].loading = false;
    }
    system_.set_history(std::move(grown));
  }
  CrackedSystem cracked_{cracked_square(GetParam().treatment, GetParam().more), GetParam().seed};
  System& system_ = cracked_.system();
};

/// Where no damage grows and nothing rubs there is a potential: R = ∂/∂d (stored + driven springs' own −
/// f·d).
TEST_P(SystemTest, ResidualIsGradientOfTheEnergy) {
  if (is_frictional()) return;
  grow_all();
  const auto energy = [&](const State& at) {
    const Loading& loading = system_.loading();
    double sum = system_.stored(at, system_.laws(at));
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
  const int fewest = cracked_.modes().minCoeff();
  ASSERT_GE(fewest, system_.multipliers().empty() ? 1 : 0) << "points that load, unload and are closed";
  ASSERT_TRUE(system_.use_tangent(system_.new_stamp(), system_.laws(at).tangent));
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
  system_.load_derivative(system_.laws(at), derivative);
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
  system_.set_history(system_.next_history(at));
  EXPECT_GT(system_.dissipated(system_.history()), dissipated);
  EXPECT_LT((vec(cracked_.residual(at)) - vec(before)).norm(), 1e-10 * vec(before).norm());
}

TEST_P(SystemTest, ArrivingTangentKeepsTheResidualAndDissipatesOnePerUnit) {
  const State at = cracked_.state();
  system_.set_history(system_.next_history(at));
  const Tangent tangent = arriving_tangent(system_, at);
  ASSERT_FALSE(tangent.d.empty());
  EXPECT_TRUE(tangent.dissipates);
  std::vector<double> change(at.d.size()), per_load(at.d.size());
  system_.path_linear().multiply(tangent.d, change);
  system_.load_derivative(system_.laws(at), per_load);
  EXPECT_LT((vec(change) + tangent.load_factor * vec(per_load)).norm(), 1e-6 * vec(change).norm());
  double rate = 0;
  for (std::size_t p = 0; p < tangent.opening.size(); ++p) {
    const InterfacePoint& point = cracked_.equilibrium().point(p);
    const Vec2 q = system_.laws(at).opening[p];
    const Vec2 gradient = point.law->spending(q, system_.history()[p], point.stiffness).gradient;
    rate += point.weight * gradient.dot(tangent.opening[p]);
  }
  EXPECT_NEAR(rate, 1, 1e-9);
}

TEST_P(SystemTest, FlexibilityOfHingesIsWhatSolutionsGive) {
  const State at = cracked_.state();
  system_.set_history(system_.next_history(at));
  arriving_tangent(system_, at);
  const Vec2 t(0.3, -0.2), component(0.8, 0.7);
  std::vector<LinearSystem::Hinge> hinges;
  for (std::size_t p = 0; p < system_.history().size(); ++p)
    if (system_.path_linear().has_columns(p))
      hinges.push_back({p, component, cracked_.equilibrium().point(p).weight * t});
  ASSERT_GE(hinges.size(), 2U);
  const auto flexibility = system_.flexibility(hinges);
  ASSERT_EQ(flexibility.has_value(), !system_.iterates_multipliers());
  if (!flexibility) return;
  for (std::size_t j = 0; j < hinges.size(); ++j) {
    const std::vector<Vec2> opened = system_.opened_by(hinges[j].point, t);
    for (std::size_t i = 0; i < hinges.size(); ++i)
      EXPECT_NEAR((*flexibility)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                  -component.dot(opened[hinges[i].point]), 1e-9 * opened[hinges[j].point].norm());
  }
}

TEST_P(SystemTest, NothingThatLeavesUnloads) {
  const State at = cracked_.state();
  system_.set_history(system_.next_history(at));
  const Tangent leaving = leaving_tangent(system_, at, arriving_tangent(system_, at));
  ASSERT_FALSE(leaving.d.empty());
  const std::vector<Vec2> openings = system_.laws(at).opening;
  for (std::size_t p = 0; p < leaving.opening.size(); ++p) {
    const History& h = system_.history()[p];
    if (!h.loading) continue;
    const InterfacePoint& point = cracked_.equilibrium().point(p);
    const Vec2 gradient = point.law->opening_gradient(openings[p], h, point.stiffness);
    EXPECT_GE(gradient.dot(leaving.opening[p]), 0);
  }
}

std::vector<SystemCase> system_cases() {
  std::vector<SystemCase> out;
  for (const std::string treatment : {"consistent", "penalty", "lagrange", "augmented_lagrangian"})
    for (const std::string more : {"", ", friction_angle: 30"})
      for (const std::uint64_t seed : {1, 2, 3}) out.push_back({treatment, more, seed});
  return out;
}

INSTANTIATE_TEST_SUITE_P(States, SystemTest, testing::ValuesIn(system_cases()));

/// D̄ = (D⁻¹ − P⁻¹ + P̄⁻¹)⁻¹ in the place of D: what the joint does once its multipliers have settled.
TEST(SystemWithIteratedMultipliers, PathTangentHasThePhysicalStiffnessOfTheJoints) {
  CrackedSystem cracked(cracked_square("{type: augmented_lagrangian, factor: 10}", ", friction_angle: 30"),
                        4);
  System& system = cracked.system();
  const State& at = cracked.state();
  const LawValues laws = system.laws(at);
  ASSERT_TRUE(system.use_path_tangent(laws));
  std::vector<Mat2> expected = laws.tangent;
  for (std::size_t p = 0; p < expected.size(); ++p) {
    const InterfacePoint& point = cracked.equilibrium().point(p);
    const Mat2 soft = point.trial_stiffness().asDiagonal(),
               stiff = point.physical_stiffness / point.stiffness * soft;
    EXPECT_GT(point.physical_stiffness / point.stiffness, 1e3);
    // A small regular part stands for the tangents of released points, which have no inverse.
    const Mat2 regular = laws.tangent[p] + 1e-7 * soft;
    expected[p] = (regular.inverse() - soft.inverse() + stiff.inverse()).inverse();
  }
  LinearSystem reference(cracked.equilibrium(), direct_solvers().choose("cholmod"),
                         LinearSystem::Update::refactorise);
  ASSERT_TRUE(reference.set_tangent(expected));
  const std::vector<double> force = cracked.direction();
  std::vector<double> found(force.size()), known(force.size());
  system.path_linear().solve(force, found);
  reference.solve(force, known);
  EXPECT_LT((vec(found) - vec(known)).norm(), 1e-4 * vec(known).norm());
  // Along the path q and m move so that the joint's own law holds: D q̇ = D̄ ġ = P ṁ.
  const std::vector<Vec2> rates = system.multiplier_rates(found);
  for (std::size_t p = 0; p < rates.size(); ++p) {
    const InterfacePoint& point = cracked.equilibrium().point(p);
    const Vec2 change = laws.tangent[p] * system.opening_rate(p, std::span<const double>(found));
    EXPECT_LT((change - point.trial_stiffness().cwiseProduct(rates[p])).norm(),
              1e-3 * (change.norm() + 1e-3 * vec(found).norm()));
  }
}

TEST(SystemWithIteratedMultipliers, GapIsWhatTheMultipliersStillMove) {
  CrackedSystem cracked(cracked_square("augmented_lagrangian"), 5);
  System& system = cracked.system();
  const State& at = cracked.state();
  const LawValues laws = system.laws(at);
  const std::vector<Vec2> next = system.next_multipliers(laws);
  double gap = 0, unit = 0;
  for (std::size_t p = 0; p < next.size(); ++p) {
    const InterfacePoint& point = cracked.equilibrium().point(p);
    EXPECT_LT((point.trial_stiffness().cwiseProduct(next[p]) - laws.traction[p]).norm(), 1e-14);
    gap = std::max(gap, (next[p] - system.multipliers()[p]).norm());
    unit = std::max(unit, laws.traction[p].norm() / point.spring_unit);
  }
  EXPECT_DOUBLE_EQ(system.relative_gap(laws), gap / unit);
  system.set_multipliers(next);
  const LawValues moved = system.laws(at);
  for (std::size_t p = 0; p < next.size(); ++p)
    EXPECT_LT((moved.opening[p] - laws.opening[p] - next[p]).norm(), 1e-14);
}

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
  std::vector<double> mu = u, q(2 * cracked.equilibrium().num_active());
  cracked.system().apply_metric(Metric::openings, mu);
  cracked.equilibrium().gather(u, q);
  double sum = 0;
  for (std::size_t i = 0; i < q.size(); ++i) sum += cracked.equilibrium().point(i / 2).weight * q[i] * q[i];
  EXPECT_NEAR(vec(mu).dot(vec(u)), sum, 1e-13);
}

}  // namespace
}  // namespace dda
