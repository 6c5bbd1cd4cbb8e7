#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/interface/law.hpp"
#include "support/sample.hpp"

namespace dda {
namespace {

/// A law with the stiffness of a point that can bear it, and the openings at which something happens.
struct LawCase {
  std::unique_ptr<InterfaceLaw> law;
  Node parameters;
  double k = 0;
  double first = 1;  ///< κ at initiation, 1 when there is none [L]
  double last = 5;   ///< κ at rupture, 5 when there is none [L]

  double kappa(const History& h) const { return std::max(h.kappa, first); }
  History random_history(Random& random) const { return {random.between(0, 1.2 * last), random.coin()}; }
  History committed(const Vec2& q, const History& h) const {
    const double opening = law->equivalent_opening(q);
    return {std::max(h.kappa, opening), opening >= kappa(h) * (1 - 1e-10)};
  }
  /// Openings at which the tangent jumps.
  bool near_kink(const Vec2& q, const History& h) const {
    constexpr double near = 1e-3;
    const double opening = law->equivalent_opening(q);
    return std::abs(q.x()) < near * first || std::abs(opening - kappa(h)) < near * first ||
           std::abs(opening - last) < near * first || opening < near * first;
  }
};

class LawContract : public testing::TestWithParam<std::string> {
 protected:
  static constexpr int cases = 5, draws = 200;

  LawCase next_case(UnitChange units = {}) {
    const FamilyMember* member = interface_laws().find(GetParam());
    LawCase out;
    out.parameters = rescaled(sample(*member->schema, random_), *member->schema, units);
    out.law = interface_laws().choose(GetParam(), out.parameters).make();
    const double slope = out.law->steepest_slope();
    const double weight = out.law->shear_weight();
    out.k = random_.between(1.5, 5) * (slope > 0 ? slope : units.factor(dimension::interface_stiffness)) /
            std::min(1.0, weight * weight);
    if (std::isfinite(out.law->initial_kappa(out.k))) out.first = out.law->initial_kappa(out.k);
    out.last = std::isfinite(out.law->rupture_kappa(out.k)) ? out.law->rupture_kappa(out.k) : 5 * out.first;
    return out;
  }

  /// Calls test(case, q, history) at random openings, in all directions and beyond rupture.
  template <class Test>
  void at_random_openings(Test test) {
    for (int c = 0; c < cases; ++c) {
      const LawCase at = next_case();
      for (int i = 0; i < draws; ++i) {
        const double size = random_.coin() ? 1.5 * at.last : 1.5 * at.first;
        const Vec2 q = random_.point(size);
        test(at, q, at.random_history(random_));
      }
    }
  }

  Random random_{20};
};

TEST_P(LawContract, TangentIsDifferenceOfTraction) {
  int loading = 0, unloading = 0, closed = 0;
  at_random_openings([&](const LawCase& at, const Vec2& q, const History& h) {
    if (at.near_kink(q, h)) return;
    (q.x() < 0 ? closed : at.law->equivalent_opening(q) > at.kappa(h) ? loading : unloading) += 1;
    const double step = 1e-6 * at.first;
    Mat2 difference;
    for (int i = 0; i < 2; ++i) {
      const Vec2 e = step * Vec2::Unit(i);
      difference.col(i) =
          (at.law->respond(q + e, h, at.k).traction - at.law->respond(q - e, h, at.k).traction) / (2 * step);
    }
    const Mat2 tangent = at.law->respond(q, h, at.k).tangent;
    EXPECT_LT((tangent - difference).norm(), 1e-7 * at.k) << "q " << q.transpose() << ", kappa " << h.kappa;
    EXPECT_LT(std::abs(tangent(0, 1) - tangent(1, 0)), 1e-12 * at.k) << "the traction has a potential";
  });
  EXPECT_GT(loading, 20);
  EXPECT_GT(unloading, 20);
  EXPECT_GT(closed, 20);
}

/// ∫ t · dq from 0 to q over `corner` by the midpoint rule.
double loading_work(const LawCase& at, const Vec2& corner, const Vec2& q) {
  constexpr int steps = 4000;
  double work = 0;
  for (const auto& [from, to] : {std::pair(Vec2(0, 0), corner), std::pair(corner, q)})
    for (int i = 0; i < steps; ++i)
      work +=
          at.law->respond(from + (i + 0.5) / steps * (to - from), {}, at.k).traction.dot(to - from) / steps;
  return work;
}

TEST_P(LawContract, WorkOfLoadingIsThatOfAPotential) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    for (int i = 0; i < 5; ++i) {
      const Vec2 q = random_.point(at.last);
      const double scale = at.k * q.squaredNorm();
      const double straight = loading_work(at, q / 2, q);
      EXPECT_NEAR(loading_work(at, {q.x(), 0}, q), straight, 1e-6 * scale);
      EXPECT_NEAR(loading_work(at, {0, q.y()}, q), straight, 1e-6 * scale);
    }
  }
}

TEST_P(LawContract, CommittingNeverCreatesEnergy) {
  // A kink inside a substep costs the trapezoid at most ¼ k |dq|²: with 1000 substeps and four kinks a leg
  // 1e-6.
  constexpr int legs = 8, substeps = 1000;
  for (int programme = 0; programme < 12; ++programme) {
    const LawCase at = next_case();
    const double weight = std::max(1.0, std::pow(at.law->shear_weight(), 2));
    History h;
    Vec2 q = Vec2::Zero(), t = Vec2::Zero();
    double work = 0, error = 0;
    for (int leg = 0; leg < legs; ++leg) {
      const Vec2 step = (random_.point(1.3 * at.last) - q) / substeps;
      error += 1e-6 * at.k * weight * (substeps * step).squaredNorm();
      for (int i = 0; i < substeps; ++i) {
        q += step;
        const Vec2 next = at.law->respond(q, h, at.k).traction;
        work += 0.5 * (t + next).dot(step);
        h = at.committed(q, h);
        t = next;
      }
      EXPECT_GE(work, 0.5 * t.dot(q) + at.law->dissipation(h.kappa, at.k) - error) << "leg " << leg;
    }
  }
}

TEST_P(LawContract, CommittingLeavesTheTraction) {
  at_random_openings([](const LawCase& at, const Vec2& q, const History& h) {
    const Vec2 before = at.law->respond(q, h, at.k).traction;
    const Vec2 after = at.law->respond(q, at.committed(q, h), at.k).traction;
    EXPECT_LT((before - after).norm(), 1e-10 * at.k * at.first);
  });
}

TEST_P(LawContract, FrozenResponseIsASecant) {
  at_random_openings([](const LawCase& at, const Vec2& q, const History& h) {
    const Response frozen = at.law->respond_frozen(q, h, at.k);
    EXPECT_LT((frozen.tangent * q - frozen.traction).norm(), 1e-12 * at.k * q.norm());
    if (at.near_kink(q, h) || at.law->equivalent_opening(q) > at.kappa(h)) return;
    const Response response = at.law->respond(q, h, at.k);
    EXPECT_LT((frozen.traction - response.traction).norm(), 1e-12 * at.k * q.norm()) << "unloading is frozen";
    EXPECT_LT((frozen.tangent - response.tangent).norm(), 1e-12 * at.k);
  });
}

TEST_P(LawContract, IntactTractionIsThatOfTheTrialStiffness) {
  at_random_openings([](const LawCase& at, const Vec2& q, const History&) {
    if (at.law->equivalent_opening(q) >= at.first) return;
    const double shear = at.k * std::pow(at.law->shear_weight(), 2);
    const Vec2 t = at.law->respond(q, {}, at.k).traction;
    EXPECT_LT((t - Vec2(at.k * q.x(), shear * q.y())).norm(), 1e-12 * (at.k + shear) * q.norm());
  });
}

TEST_P(LawContract, OpeningGradientIsDerivative) {
  at_random_openings([](const LawCase& at, const Vec2& q, const History& h) {
    if (at.near_kink(q, h)) return;
    const double step = 1e-6 * at.first;
    for (int i = 0; i < 2; ++i) {
      const Vec2 e = step * Vec2::Unit(i);
      const double difference =
          (at.law->equivalent_opening(q + e) - at.law->equivalent_opening(q - e)) / (2 * step);
      EXPECT_NEAR(at.law->opening_gradient(q)[i], difference, 1e-6 * (1 + at.law->shear_weight()));
    }
  });
}

TEST_P(LawContract, DissipationAndDamageGrowWithTheOpening) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    const InterfaceLaw& law = *at.law;
    const double step = 1e-6 * at.first, scale = at.k * at.first;
    double kappa = 0;
    for (int i = 0; i < draws; ++i) {
      const double before = kappa;
      kappa += random_.between(0, 2.4 / draws) * at.last;
      EXPECT_GE(law.dissipation(kappa, at.k), law.dissipation(before, at.k));
      EXPECT_GE(law.damage(kappa, at.k), law.damage(before, at.k));
      EXPECT_GE(law.damage(kappa, at.k), 0);
      EXPECT_LE(law.damage(kappa, at.k), 1);
      if (std::abs(kappa - at.first) < 2 * step || std::abs(kappa - at.last) < 2 * step) continue;
      const double difference =
          (law.dissipation(kappa + step, at.k) - law.dissipation(kappa - step, at.k)) / (2 * step);
      EXPECT_NEAR(law.dissipation_slope(kappa, at.k), difference, 1e-7 * scale) << "kappa " << kappa;
    }
    EXPECT_EQ(law.dissipation(at.first, at.k), 0);
    EXPECT_EQ(law.damage(at.first, at.k), 0);
  }
}

TEST_P(LawContract, RuptureSpendsTheFractureEnergy) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    EXPECT_EQ(at.law->can_crack(), std::isfinite(at.law->initial_kappa(at.k)));
    EXPECT_EQ(at.law->can_crack(), std::isfinite(at.law->rupture_kappa(at.k)));
    if (!at.law->can_crack()) continue;
    EXPECT_LT(at.first, at.last);
    EXPECT_NEAR(at.law->damage(at.last, at.k), 1, 1e-12);
    EXPECT_LT(at.law->respond({at.last, 0}, {at.last, false}, at.k).traction.norm(), 1e-12 * at.k * at.first);
    const Node* energy = at.parameters.find("fracture_energy");
    if (!energy) continue;
    EXPECT_NEAR(at.law->dissipation(at.last, at.k) / std::stod(energy->text), 1, 1e-12);
  }
}

TEST_P(LawContract, SteepestSlopeBoundsTheSoftening) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    double steepest = 0, kappa = at.first, traction = at.law->respond({kappa, 0}, {}, at.k).traction.x();
    for (int i = 1; i <= 1000; ++i) {
      const double next = at.first + (at.last - at.first) * i / 1000;
      const double reached = at.law->respond({next, 0}, {}, at.k).traction.x();
      const double opening = next - kappa - (reached - traction) / at.k;
      if (traction > reached) steepest = std::max(steepest, (traction - reached) / opening);
      kappa = next;
      traction = reached;
    }
    EXPECT_LE(steepest, at.law->steepest_slope() * (1 + 1e-6));
    EXPECT_GE(steepest, at.law->steepest_slope() * 0.98) << "a bound that large costs stiffness for nothing";
  }
}

TEST_P(LawContract, ParametersInOtherUnitsGiveTheSameLaw) {
  const UnitChange units{1e-3, 0.025};
  const double stress = units.factor(dimension::stress);
  for (int c = 0; c < cases; ++c) {
    Random repeated = random_;
    const LawCase at = next_case();
    std::swap(repeated, random_);
    const LawCase other = next_case(units);
    EXPECT_NEAR(other.k, at.k * units.factor(dimension::interface_stiffness), 1e-12 * other.k);
    for (int i = 0; i < draws; ++i) {
      const Vec2 q = random_.point(1.5 * at.last);
      const History h = at.random_history(random_);
      const Vec2 t = at.law->respond(q, h, at.k).traction;
      const Vec2 same =
          other.law->respond(units.length * q, {units.length * h.kappa, h.loading}, other.k).traction;
      EXPECT_LT((same - stress * t).norm(), 1e-10 * stress * at.k * at.last);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, LawContract, testing::ValuesIn(names_of(interface_laws())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
