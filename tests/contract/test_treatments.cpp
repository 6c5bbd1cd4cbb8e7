#include <gtest/gtest.h>

#include "models/treatment/trace_constant.hpp"
#include "models/treatment/treatment.hpp"
#include "support/sample.hpp"

namespace dda {
namespace {

/// Two random triangles with a common side, of the same elasticity or of unlike ones.
struct Pair {
  Block first, second;
  SideFaces faces;
  Vec2 x;  ///< on the side

  Vec6 motion(const Block& block, const Vec2& a, const Mat2& g) const {
    const Vec2 u = a + g * block.moments.centroid;
    Vec6 d;
    d << u, (g(1, 0) - g(0, 1)) / 2, g(0, 0), g(1, 1), g(0, 1) + g(1, 0);
    return d;
  }
  Mat26 rows(const Block& block) const { return displacement_rows(x - block.moments.centroid); }
};

Mat3 isotropic(double e, double nu) {
  Mat3 c;
  c << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  return e / (1 - nu * nu) * c;
}

Block triangle(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Polygon outline{{a, b, c}};
  return {outline, moments(outline), 0};
}

Pair random_pair(Random& random, bool alike, const UnitChange& units = {}) {
  const double l = units.length, stress = units.factor(dimension::stress);
  const Vec2 start(0, 0), end(random.between(1, 2) * l, random.between(-0.5, 0.5) * l);
  Pair out;
  // The first block lies left of the side, its outward normal points right.
  out.first = triangle(start, end, Vec2(random.between(0, 1), random.between(1, 2)) * l);
  out.second = triangle(end, start, Vec2(random.between(0, 1), random.between(-2, -1)) * l);
  const Vec2 edge = end - start;
  const double e = random.between(1, 3) * stress, nu = random.between(0, 0.4);
  const double other = alike ? e : random.between(1, 30) * stress;
  const Mat3 c = isotropic(e, nu), c_other = isotropic(other, nu);
  out.faces = {{c, trace_constant(out.first, c), e},
               {c_other, trace_constant(out.second, c_other), other},
               (out.first.moments.centroid - out.second.moments.centroid).norm(),
               edge.norm(),
               Vec2(edge.y(), -edge.x()) / edge.norm()};
  out.x = start + random.between(0, 1) * edge;
  return out;
}

class TreatmentContract : public testing::TestWithParam<std::string> {
 protected:
  static constexpr int cases = 50;
  const SchemaBase& schema() const { return *treatments().find(GetParam())->schema; }
  std::unique_ptr<Treatment> make(const Node& parameters) const {
    return treatments().choose(GetParam(), parameters).make();
  }
  std::unique_ptr<Treatment> next() { return make(sample(schema(), random_)); }
  PointRows rows(const Treatment& treatment, const Pair& pair, const Vec2& p) const {
    return treatment.rows(pair.faces, {pair.rows(pair.first), strain_rows()},
                          {pair.rows(pair.second), strain_rows()}, p);
  }
  Random random_{22};
};

TEST_P(TreatmentContract, RigidMotionsGiveTheirJump) {
  for (int i = 0; i < cases; ++i) {
    const auto treatment = next();
    const Pair pair = random_pair(random_, false);
    const double k = treatment->stiffness(pair.faces);
    const PointRows at = rows(*treatment, pair, {k, 0.5 * k});
    Mat2 turn[2];
    Vec2 shift[2];
    for (int b = 0; b < 2; ++b) {
      const double angle = random_.between(-1, 1);
      turn[b] << 0, -angle, angle, 0;
      shift[b] = random_.point(1);
    }
    const Vec2 common = at.first * pair.motion(pair.first, shift[0], turn[0]) +
                        at.second * pair.motion(pair.second, shift[0], turn[0]);
    EXPECT_LT(common.norm(), 1e-13);
    const Vec2 q = at.first * pair.motion(pair.first, shift[0], turn[0]) +
                   at.second * pair.motion(pair.second, shift[1], turn[1]);
    const Vec2 jump = shift[1] + turn[1] * pair.x - shift[0] - turn[0] * pair.x;
    const Vec2 n = pair.faces.normal, s(-n.y(), n.x());
    EXPECT_LT((q - Vec2(n.dot(jump), s.dot(jump))).norm(), 1e-13);
  }
}

TEST_P(TreatmentContract, UniformStressGivesItsShareOfTheTrialTraction) {
  for (int i = 0; i < cases; ++i) {
    const auto treatment = next();
    const Pair pair = random_pair(random_, true);
    const Vec2 weights = treatment->stress_weights(pair.faces);
    EXPECT_TRUE(weights.isZero() || std::abs(weights.sum() - 1) < 1e-14) << weights.transpose();
    const double k = treatment->stiffness(pair.faces);
    const Vec2 p(k, 0.5 * k);
    const PointRows at = rows(*treatment, pair, p);
    Mat2 g;
    g << random_.point(1), random_.point(1);
    const Vec6 first = pair.motion(pair.first, {1, 2}, g), second = pair.motion(pair.second, {1, 2}, g);
    const Vec3 stress = pair.faces.first.stiffness * first.tail<3>();
    const Vec2 n = pair.faces.normal, s(-n.y(), n.x());
    Mat2 tensor;
    tensor << stress.x(), stress.z(), stress.z(), stress.y();
    const Vec2 traction = weights.sum() * Vec2(n.dot(tensor * n), s.dot(tensor * n));
    EXPECT_LT((p.cwiseProduct(at.first * first + at.second * second) - traction).norm(), 1e-12 * k);
    EXPECT_LT((at.first_stress * first + at.second_stress * second - traction).norm(), 1e-12 * stress.norm());
  }
}

TEST_P(TreatmentContract, StiffnessIsPositiveAndDoesNotDependOnTheOrderOfTheBlocks) {
  for (int i = 0; i < cases; ++i) {
    const auto treatment = next();
    const Pair pair = random_pair(random_, false);
    SideFaces turned = pair.faces;
    std::swap(turned.first, turned.second);
    turned.normal = -turned.normal;
    const double k = treatment->stiffness(pair.faces);
    EXPECT_GT(k, 0);
    EXPECT_GE(treatment->largest_stiffness(pair.faces), k);
    EXPECT_NEAR(treatment->stiffness(turned) / k, 1, 1e-14);
    const Vec2 weights = treatment->stress_weights(pair.faces), swapped = treatment->stress_weights(turned);
    EXPECT_LT((weights - Vec2(swapped.y(), swapped.x())).norm(), 1e-14);
  }
}

TEST_P(TreatmentContract, ParametersInOtherUnitsGiveTheSameJoint) {
  const UnitChange units{1e-3, 0.025};
  for (int i = 0; i < cases; ++i) {
    const Node parameters = sample(schema(), random_);
    Random repeated = random_;
    const Pair pair = random_pair(random_, false);
    const Pair same = random_pair(repeated, false, units);
    const auto treatment = make(parameters), other = make(rescaled(parameters, schema(), units));
    const double factor = units.factor(dimension::interface_stiffness);
    EXPECT_NEAR(other->stiffness(same.faces) / factor / treatment->stiffness(pair.faces), 1, 1e-12);
    EXPECT_NEAR(other->largest_stiffness(same.faces) / factor / treatment->largest_stiffness(pair.faces), 1,
                1e-12);
  }
}

TEST_P(TreatmentContract, OnlyMultipliersArePerturbedThoseOfContactMore) {
  for (int i = 0; i < cases; ++i) {
    const auto treatment = next();
    const double bonded = treatment->perturbation(false), touching = treatment->perturbation(true);
    EXPECT_EQ(bonded > 0, treatment->multiplier() == Multiplier::unknown);
    EXPECT_EQ(touching > 0, treatment->multiplier() != Multiplier::none);
    EXPECT_TRUE(touching > bonded || treatment->multiplier() != Multiplier::iterated);
  }
}

/// What carries the stress in a multiplier does not take it from the blocks as well.
TEST_P(TreatmentContract, MultipliersExcludeStresses) {
  const auto treatment = next();
  const Pair pair = random_pair(random_, false);
  EXPECT_TRUE(treatment->multiplier() == Multiplier::none || treatment->stress_weights(pair.faces).isZero());
}

TEST_P(TreatmentContract, PathTakesAtLeastTheStiffnessOfTheIteration) {
  const UnitChange units{1e-3, 0.025};
  for (int i = 0; i < cases; ++i) {
    const Node parameters = sample(schema(), random_);
    Random repeated = random_;
    const Pair pair = random_pair(random_, false), same = random_pair(repeated, false, units);
    const auto treatment = make(parameters), other = make(rescaled(parameters, schema(), units));
    const double physical = treatment->physical_stiffness(pair.faces);
    EXPECT_GE(physical, treatment->stiffness(pair.faces));
    EXPECT_TRUE(treatment->multiplier() != Multiplier::none || physical == treatment->stiffness(pair.faces));
    EXPECT_NEAR(
        other->physical_stiffness(same.faces) / units.factor(dimension::interface_stiffness) / physical, 1,
        1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, TreatmentContract, testing::ValuesIn(names_of(treatments())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
