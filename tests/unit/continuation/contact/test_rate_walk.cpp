// Rates of random small structures whose points stand at corners of their laws.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "continuation/contact/rate_walk.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Hinges that soften, each taking and giving as a random stiffness says; with `friction` M is not symmetric.
HingedRates random_rates(Random& random, int hinges, double softening, double friction) {
  HingedRates out{Matrix(hinges, hinges), Vector(hinges)};
  Matrix a(hinges, hinges);
  for (double& value : a.reshaped()) value = random.between(-1, 1);
  out.couplings = -softening * a * a.transpose() / hinges;
  for (double& value : out.couplings.reshaped()) value += friction * random.between(-1, 1);
  for (double& value : out.per_load) value = random.between(-0.5, 1);
  return out;
}

/// ψ of a ray, up to a positive factor: the kernel of the equations of its hinges that go on.
Vector rates_of(const HingedRates& rates, const RateRay& ray) {
  const Eigen::Index n = rates.per_load.size();
  Matrix equations(n, n + 1);
  equations.leftCols(n).setIdentity();
  for (Eigen::Index j = 0; j < n; ++j)
    if (ray.goes_on[static_cast<std::size_t>(j)]) equations.col(j) += rates.couplings.col(j);
  equations.rightCols(1) = -rates.per_load;
  Vector kernel = equations.fullPivLu().kernel().col(0);
  if (kernel[n] * ray.load_factor < 0) kernel = -kernel;
  return kernel.head(n) / kernel.lpNorm<Eigen::Infinity>();
}

/// By how much hinges that go on have ψ < 0, or others ψ > 0.
double contradiction(const Vector& psi, const RateRay& ray) {
  double out = 0;
  for (Eigen::Index i = 0; i < psi.size(); ++i)
    out = std::max(out, ray.goes_on[static_cast<std::size_t>(i)] ? -psi[i] : psi[i]);
  return out;
}

TEST(RateWalk, FindsDirectionsWhateverSoftensAndSlides) {
  Random random(11);
  int found = 0, all = 0;
  for (const double softening : {0.0, 0.5, 1.5, 4.0})
    for (const double friction : {0.0, 0.1, 0.3})
      for (int i = 0; i < 20; ++i) {
        const HingedRates rates = random_rates(random, 30, softening, friction);
        const auto up = follow_hinges(rates, 1), down = follow_hinges(rates, -1);
        for (const auto& ray : {up, down})
          EXPECT_LT(ray ? contradiction(rates_of(rates, *ray), *ray) : 0, 1e-9);
        EXPECT_TRUE(!up || !down || up->goes_on != down->goes_on || up->load_factor * down->load_factor < 0);
        found += up && down;
        ++all;
      }
  EXPECT_GT(found, 0.5 * all);
}

/// All rays there are, by trying every set of hinges.
std::vector<RateRay> all_rays(const HingedRates& rates) {
  const auto n = static_cast<std::size_t>(rates.per_load.size());
  std::vector<RateRay> out;
  for (std::size_t set = 0; set < std::size_t{1} << n; ++set)
    for (const double load : {1.0, -1.0}) {
      RateRay ray{{}, load};
      for (std::size_t i = 0; i < n; ++i) ray.goes_on.push_back((set >> i & 1) != 0);
      if (contradiction(rates_of(rates, ray), ray) < 1e-9) out.push_back(ray);
    }
  return out;
}

TEST(RateWalk, FindsNothingOnlyWhereThereIsNothing) {
  Random random(12);
  int none = 0;
  for (const double friction : {0.0, 0.3, 1.0, 2.0})
    for (int i = 0; i < 40; ++i) {
      const HingedRates rates = random_rates(random, 6, 1.5, friction);
      const auto known = all_rays(rates);
      EXPECT_EQ(known.size() % 2, 0);
      for (const double direction : {1.0, -1.0})
        EXPECT_EQ(follow_hinges(rates, direction).has_value(), !known.empty()) << friction << " " << i;
      none += known.empty();
    }
  EXPECT_GT(none, 0);
}

/// One hinge that its load opens and that takes more than the load gives: the load falls while it goes on,
/// and while it rests.
TEST(RateWalk, GoesOnBeyondALimitPoint) {
  const HingedRates rates{Matrix::Constant(1, 1, -1.5), Vector::Ones(1)};
  const auto onward = follow_hinges(rates, 1), back = follow_hinges(rates, -1);
  ASSERT_TRUE(onward && back);
  EXPECT_TRUE(onward->goes_on[0]);
  EXPECT_LT(onward->load_factor, 0);
  EXPECT_FALSE(back->goes_on[0]);
  EXPECT_LT(back->load_factor, 0);
}

/// Two alike under one load, each taking more from itself than from the other: one goes on and the other
/// rests.
TEST(RateWalk, OneOfTwoGoesOnWhereBothCannot) {
  const HingedRates rates{(Matrix(2, 2) << -1.5, 0.5, 0.5, -1.5).finished(), Vector::Ones(2)};
  const auto onward = follow_hinges(rates, 1);
  ASSERT_TRUE(onward);
  EXPECT_NE(onward->goes_on[0], onward->goes_on[1]);
}

}  // namespace
}  // namespace dda
