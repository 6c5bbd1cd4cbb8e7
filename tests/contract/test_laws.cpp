#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "contract/law_contract.hpp"
#include "models/interface/coulomb.hpp"

namespace dda {
namespace {

/// ‖D‖ of a law with a steep friction angle is some 10 k; curvature leaves 1e-12 of a difference over 1e-6.
constexpr double difference_error = 2e-7;

TEST_P(LawContract, TangentIsDifferenceOfTraction) {
  at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
    const Mat2 tangent = at.law->respond(q, h, at.k).tangent;
    const Mat2 difference = differences(at, q, [&](const Vec2& x) { return at.traction(x, h); });
    EXPECT_LT((tangent - difference).norm(), difference_error * at.stiff())
        << "q " << q.transpose() / at.first << ", kappa " << at.law->kappa(h, at.k) / at.first
        << " of the first\n"
        << at.text();
  });
}

TEST_P(LawContract, TangentIsSymmetricWhereThereIsAPotential) {
  int frictional = 0;
  at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
    const Mat2 tangent = at.law->respond(q, h, at.k).tangent;
    const double skew = std::abs(tangent(0, 1) - tangent(1, 0));
    if (at.has_potential())
      EXPECT_LT(skew, 1e-12 * at.stiff());
    else
      frictional += skew > 1e-3 * at.k;
  });
  const LawCase at = random_law(GetParam(), random_, true);
  EXPECT_GE(frictional, at.is_frictional() ? 20 : 0);
}

TEST_P(LawContract, FrozenTangentIsDifferenceOfFrozenTraction) {
  at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
    const Response frozen = at.law->respond_frozen(q, h, at.k);
    const Mat2 difference =
        differences(at, q, [&](const Vec2& x) { return at.law->respond_frozen(x, h, at.k).traction; });
    EXPECT_LT((frozen.tangent - difference).norm(), difference_error * at.stiff());
    if (at.opening(q, h) > at.law->kappa(h, at.k)) return;
    const Response response = at.law->respond(q, h, at.k);
    EXPECT_LT((frozen.traction - response.traction).norm(), 1e-12 * at.stiff() * q.norm())
        << "unloading is frozen";
    EXPECT_LT((frozen.tangent - response.tangent).norm(), 1e-12 * at.stiff());
  });
}

TEST_P(LawContract, FrictionBoundedByAnotherClosingHasAPotentialUnderPressure) {
  at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
    const double own = closing_of(q);
    const Response bounded = at.law->respond_bounded(q, h, at.k, own), free = at.law->respond(q, h, at.k);
    EXPECT_LT((bounded.traction - free.traction).norm(), 1e-12 * at.stiff() * q.norm());
    if (own == 0 || at.is_filled || h.share > 0) return;
    const double other = 1.5 * own;
    const auto traction = [&](const Vec2& x) { return at.law->respond_bounded(x, h, at.k, other).traction; };
    const Mat2 tangent = at.law->respond_bounded(q, h, at.k, other).tangent;
    EXPECT_LT((tangent - differences(at, q, traction)).norm(), difference_error * at.stiff()) << at.text();
    EXPECT_LT(std::abs(tangent(0, 1) - tangent(1, 0)), 1e-12 * at.stiff()) << at.text();
  });
}

/// Sequentially linear steps rely on it.
TEST_P(LawContract, FrozenTractionOfSofteningWithoutFrictionIsASecant) {
  at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
    if (at.is_frictional() || at.law->releases_at_once() || at.is_filled) return;
    const Response frozen = at.law->respond_frozen(q, h, at.k);
    EXPECT_LT((frozen.tangent * q - frozen.traction).norm(), 1e-12 * at.stiff() * q.norm());
  });
}

TEST_P(LawContract, OpeningGradientIsDifference) {
  at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
    const double step = 1e-6 * at.first;
    for (int i = 0; i < 2; ++i) {
      const Vec2 e = step * Vec2::Unit(i);
      const double difference = (at.opening(q + e, h) - at.opening(q - e, h)) / (2 * step);
      const Vec2 gradient = at.law->opening_gradient(q, h, at.k);
      EXPECT_NEAR(gradient[i], difference, 2e-6 * (1 + gradient.norm()))
          << "q " << q.transpose() / at.first << "\n"
          << at.text();
    }
  });
}

TEST_P(LawContract, SpendingGradientIsDifference) {
  at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
    const double step = 1e-6 * at.first;
    for (int i = 0; i < 2; ++i) {
      const Vec2 e = step * Vec2::Unit(i);
      const double difference =
          (at.law->spending(q + e, h, at.k).value - at.law->spending(q - e, h, at.k).value) / (2 * step);
      EXPECT_NEAR(at.law->spending(q, h, at.k).gradient[i], difference,
                  10 * difference_error * at.stiff() * at.last)
          << "q " << q.transpose() / at.first << "\n"
          << at.text();
    }
  });
}

TEST_P(LawContract, WhatSlidesOnSpendsFromTheStartOfAStep) {
  at_accepted_states([](const LawCase& at, const Vec2& q, const History&, const History& after) {
    if (!after.sliding || !(q.x() < -1e-3 * at.first)) return;
    const Vec2 step = 1e-6 * at.first * at.law->slip_gradient(q, after, at.k).normalized();
    History h = after;
    h.loading = after.loading && at.law->opening_gradient(q, after, at.k).dot(step) > 0;
    const double spent = at.law->spending(q + step, h, at.k).value;
    EXPECT_NEAR(at.law->spending(q, h, at.k).gradient.dot(step), spent, 1e-2 * spent) << at.text();
  });
}

TEST_P(LawContract, AcceptingAddsWhatIsSpent) {
  at_accepted_states([](const LawCase& at, const Vec2& q, const History& before, const History& after) {
    EXPECT_EQ(after.dissipated, before.dissipated + at.law->spending(q, before, at.k).value);
  });
}

TEST_P(LawContract, AcceptingLeavesTractionEnergyAndDamageSurface) {
  at_accepted_states([](const LawCase& at, const Vec2& q, const History& before, const History& after) {
    const double force = at.stiff() * at.last, energy = force * at.last;
    EXPECT_LT((at.traction(q, before) - at.traction(q, after)).norm(), 1e-9 * force);
    EXPECT_NEAR(at.law->stored(q, before, at.k), at.law->stored(q, after, at.k), 1e-9 * energy);
    EXPECT_NEAR(at.law->spending(q, after, at.k).value, 0, 1e-9 * energy) << "nothing is spent twice";
    EXPECT_GE(at.law->kappa(after, at.k), at.law->kappa(before, at.k));
    EXPECT_GE(at.law->damage(after, at.k), at.law->damage(before, at.k));
    EXPECT_GE(at.law->damage(after, at.k), 0);
    EXPECT_LE(at.law->damage(after, at.k), 1);
  });
}

/// Forward differences from an accepted state, on each side of the surfaces that it lies on. What fails at
/// once and what is being released is left by a release, not by a tangent.
TEST_P(LawContract, FlagsChooseTheSideOfTheSurface) {
  int surfaces = 0;
  at_accepted_states([&](const LawCase& at, const Vec2& q, const History&, const History& accepted) {
    History h = accepted;
    const Vec2 opens = at.law->opening_gradient(q, h, at.k), slips = at.law->slip_gradient(q, h, at.k);
    if (!(h.loading || h.sliding) ||
        (at.law->releases_at_once() && (at.law->damage(h, at.k) == 0 || h.share > 0)))
      return;
    ++surfaces;
    for (const double sign : {1.0, -1.0}) {
      h.loading = accepted.loading && sign > 0;
      h.sliding = accepted.sliding && sign > 0;
      const Vec2 along = sign * (opens.normalized() + slips.normalized()).normalized() * at.first;
      if (sign * along.dot(opens) < 0 || sign * along.dot(slips) < 0 || along.isZero()) continue;
      constexpr double step = 1e-6;
      const Vec2 difference = (at.traction(q + step * along, h) - at.traction(q, h)) / step;
      EXPECT_LT((at.law->respond(q, h, at.k).tangent * along - difference).norm(),
                1e-3 * at.stiff() * at.first)
          << "side " << sign << ", q " << q.transpose() / at.first << ", loading " << accepted.loading
          << ", sliding " << accepted.sliding << "\n"
          << at.text();
    }
  });
  EXPECT_GE(surfaces, random_law(GetParam(), random_, true).law->can_crack() ? 50 : 0);
}

/// Events end on a strength but for rounding, on either side of it: a crack leaves it by the same tangent.
TEST_P(LawContract, LoadingTangentIsTheSameOnBothSidesOfAStrength) {
  int strengths = 0;
  for (int draw = 0; draw < cases * draws; ++draw) {
    const LawCase at = next_case();
    const double kappa = at.law->initial_kappa(at.k);
    Vec2 q = random_.point(1.5 * at.first);
    if (!std::isfinite(kappa) || at.law->releases_at_once()) continue;
    double low = 0, high = 100;
    while (high - low > 1e-15 * high)
      (at.opening(0.5 * (low + high) * q, {}) > kappa ? high : low) = 0.5 * (low + high);
    if (high == 100) continue;  // pressed: no strength on this ray
    ++strengths;
    q *= high;
    const History on{.loading = true};
    constexpr double rounding = 1e-12;
    const Mat2 below = at.law->respond((1 - rounding) * q, on, at.k).tangent;
    const Mat2 above = at.law->respond((1 + rounding) * q, on, at.k).tangent;
    EXPECT_LT((below - above).norm(), 1e-6 * at.stiff()) << "q " << q.transpose() / at.first << "\n"
                                                         << at.text();
  }
  EXPECT_GE(strengths, random_law(GetParam(), random_, true).law->steepest_slope() > 0 ? 50 : 0);
}

/// Where friction is exhausted the gradient points to where the joint goes on sliding.
TEST_P(LawContract, SlipGradientPointsToMoreSliding) {
  int sliding = 0;
  at_accepted_states([&](const LawCase& at, const Vec2& q, const History&, const History& h) {
    const Vec2 gradient = at.law->slip_gradient(q, h, at.k);
    if (!h.sliding) return;
    ++sliding;
    const double step = 1e-4 * at.first;
    for (const double sign : {1.0, -1.0}) {
      const Vec2 next = q + sign * step * gradient.normalized();
      const double slipped = remembered_number(*at.law, at.law->accept(next, h, at.k), "slip") -
                             remembered_number(*at.law, h, "slip");
      if (sign > 0)
        EXPECT_GT(slipped * gradient.y(), 0);
      else
        EXPECT_NEAR(slipped, 0, 1e-12 * at.last);
    }
  });
  EXPECT_GE(sliding, GetParam() == "friction" ? 100 : 0);
}

/// Traction along a straight line through everything: no jump larger than the line's own step explains.
TEST_P(LawContract, TractionIsContinuous) {
  at_random_states([&](const LawCase& at, const Vec2& from, const History& h) {
    const Vec2 step = (random_opening(at) - from) / 100;
    for (int i = 0; i < 100; ++i) {
      const Vec2 q = from + i * step;
      const double jump = (at.traction(q + step, h) - at.traction(q, h)).norm();
      EXPECT_LT(jump, 20 * at.stiff() * step.norm());
    }
    for (const double y : {from.y(), -from.y()})
      EXPECT_LT((at.traction({1e-12 * at.first, y}, h) - at.traction({-1e-12 * at.first, y}, h)).norm(),
                1e-9 * at.stiff() * at.first)
          << "contact";
  });
}

TEST_P(LawContract, IntactTractionIsThatOfTheIntactStiffness) {
  int intact = 0;
  at_random_states([&](const LawCase& at, const Vec2& q, const History&) {
    if (at.law->piece(q, {}, at.k) != 0) return;
    ++intact;
    const Vec2 stiffness = at.law->intact_stiffness(at.k);
    EXPECT_LT((at.traction(q, {}) - stiffness.cwiseProduct(q)).norm(), 1e-12 * at.stiff() * q.norm());
    EXPECT_EQ(at.law->spending(q, {}, at.k).value, 0);
    EXPECT_NEAR(at.law->stored(q, {}, at.k), 0.5 * q.dot(stiffness.cwiseProduct(q)),
                1e-12 * at.stiff() * q.squaredNorm());
  });
  EXPECT_GT(intact, 100);
}

TEST_P(LawContract, IntactPointsWithinTheBoundNeedNotBeAsked) {
  int bounded = 0;
  at_random_states([&](const LawCase& at, const Vec2& anywhere, const History& h) {
    const double bound = at.law->intact_bound(h, at.k), beta = at.law->shear_weight();
    if (h.loading || h.sliding || h.dissipated != 0 || bound == 0) return;
    ++bounded;
    const double size = std::hypot(std::max(anywhere.x(), 0.0), beta * anywhere.y());
    const Vec2 q = size > 0 ? Vec2(random_.between(0, 0.999) * bound / size * anywhere) : anywhere;
    const Vec2 stiffness = at.law->intact_stiffness(at.k);
    for (const Response& said : {at.law->respond(q, h, at.k), at.law->respond_frozen(q, h, at.k)}) {
      EXPECT_LE((said.traction - stiffness.cwiseProduct(q)).norm(), 1e-15 * at.stiff() * q.norm());
      EXPECT_LE((said.tangent - Mat2(stiffness.asDiagonal())).norm(), 1e-15 * at.stiff());
    }
    EXPECT_EQ(at.law->spending(q, h, at.k).value, 0);
  });
  const LawCase at = random_law(GetParam(), random_, true);
  EXPECT_GE(bounded, at.law->intact_bound({}, at.k) > 0 ? 50 : 0);
}

/// What is not declared is lost in a restart, and what is declared twice has no place of its own.
TEST_P(LawContract, KeepsWhatItDeclaresAndNothingElse) {
  std::vector<bool> kept;
  at_accepted_states([&](const LawCase& at, const Vec2&, const History&, const History& after) {
    std::set<std::string> names;
    std::size_t size = 0;
    for (const Remembered& one : at.law->memory()) {
      EXPECT_TRUE(names.insert(one.name).second) << one.name;
      size += static_cast<std::size_t>(one.size);
    }
    ASSERT_LE(size, LawMemory::capacity);
    if (size > kept.size()) kept.resize(size, false);
    const auto& numbers = after.memory.numbers();
    EXPECT_TRUE(std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(size), numbers.end(),
                            [](double number) { return number == 0; }));
    for (std::size_t i = 0; i < size; ++i) kept[i] = kept[i] || numbers[i] != 0;
  });
  EXPECT_EQ(std::ranges::count(kept, false), 0) << "declared, but never anything else than 0";
}

TEST_P(LawContract, SofteningIsAsSteepAsTheLawSays) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    if (!at.law->can_crack() || at.law->steepest_slope() == 0 || at.is_filled) continue;
    double steepest = 0;
    for (const Vec2& mode : {Vec2(1, 0), Vec2(0, 1 / at.law->shear_weight())}) {
      const double strength = at.traction(at.first * mode, {}).dot(mode) / at.first;
      double opening = 0, traction = strength * at.first;
      for (int i = 1; i <= 4000; ++i) {
        const double q = at.first + 2 * (at.last - at.first) * i / 4000;
        const double reached = at.traction(q * mode, {}).dot(mode), w = q - reached / strength;
        if (w > opening) steepest = std::max(steepest, (traction - reached) / (w - opening));
        opening = w;
        traction = reached;
      }
    }
    EXPECT_LE(steepest, at.law->steepest_slope() * (1 + 1e-6));
    EXPECT_GE(steepest, at.law->steepest_slope() * 0.98) << "a bound that large costs stiffness for nothing";
  }
}

TEST_P(LawContract, RuptureReleasesTheTraction) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    const double end = at.law->rupture_kappa(at.k);
    if (!std::isfinite(end) || at.is_filled) continue;
    EXPECT_LT(at.first, end);
    const History h = at.law->accept({end, 0}, {}, at.k);
    EXPECT_TRUE(at.law->is_broken(h, at.k));
    EXPECT_NEAR(at.law->damage(h, at.k), 1, 1e-12);
    EXPECT_LT(at.traction({end, 0}, h).norm(), 1e-12 * at.k * at.first);
    EXPECT_NEAR(h.dissipated / std::stod(at.parameters.find("fracture_energy")->text), 1, 1e-12);
  }
}

TEST_P(LawContract, BrokenJointsSlideByTheFrictionThatTheLawNames) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    const double far = 2 * std::max(at.first, at.last),
                 beta2 = at.law->shear_weight() * at.law->shear_weight();
    History h = at.law->accept({far, 0}, {}, at.k);
    if (at.law->releases_at_once()) h = at.law->release({far, 0}, {}, at.k, 0);
    const auto contact = at.law->contact(h, at.k);
    if (!contact) continue;
    EXPECT_NEAR(at.law->residual_friction().value_or(0), beta2 * contact->coefficient, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, LawContract, testing::ValuesIn(names_of(interface_laws())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
