#pragma once

#include <gtest/gtest.h>

#include "support/law_case.hpp"

namespace dda {

/// Random laws of one member of the family at random openings and histories.
class LawContract : public testing::TestWithParam<std::string> {
 protected:
  static constexpr int cases = 12, draws = 150;

  /// Every other law has what may be absent, every third has no friction, every fifth is scaled, and cracks of every fourth
  /// are filled by water.
  LawCase next_case() {
    ++number_;
    LawCase at = random_law(GetParam(), random_, number_ % 2 == 0);
    if (number_ % 3 == 0) at = without_friction(GetParam(), std::move(at));
    if (number_ % 5 == 0) at = scaled(std::move(at), 0.5 + 0.1 * (number_ % 10), 1.7);
    if (number_ % 4 == 0) at = filled(std::move(at), 0.5);
    return at;
  }
  /// A place anywhere from intact to beyond rupture.
  Vec2 random_opening(const LawCase& at) {
    return random_.point(1.5 * (random_.coin() ? at.last : at.first));
  }

  /// Calls test(case, q, history) at random openings and reachable histories.
  template <class Test>
  void at_random_states(Test test) {
    for (int c = 0; c < cases; ++c) {
      const LawCase at = next_case();
      for (int i = 0; i < draws; ++i) {
        const History h = i % 10 == 0 ? History{} : at.reachable(random_);
        test(at, random_opening(at), h);
      }
    }
  }
  /// The same at states that have just been accepted: on surfaces, with flags.
  template <class Test>
  void at_accepted_states(Test test) {
    at_random_states([&](const LawCase& at, const Vec2& q, const History& h) {
      const Vec2 place = at.admissible(q, h);
      test(at, place, h, at.law->accept(place, h, at.k));
    });
  }
  /// Central differences of a function of q with values of two components.
  template <class Function>
  static Mat2 differences(const LawCase& at, const Vec2& q, Function function) {
    const double step = 1e-6 * at.first;
    Mat2 out;
    for (int i = 0; i < 2; ++i) {
      const Vec2 e = step * Vec2::Unit(i);
      out.col(i) = (function(q + e) - function(q - e)) / (2 * step);
    }
    return out;
  }

  Random random_{20};
  int number_ = 0;
};

}  // namespace dda
