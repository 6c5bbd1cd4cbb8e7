#pragma once

#include <algorithm>

#include "models/treatment/treatment.hpp"

namespace dda {

/// A joint that is nothing but a spring across the jump, q = g (+ m): stress does not enter.
class SpringJoint : public Treatment {
 public:
  /// k = factor · E/(centroid distance), which a steep law may raise to 1e4 of that unit.
  explicit SpringJoint(double factor) : factor_(factor) {}

  double stiffness(const SideFaces& side) const override { return factor_ * unit(side); }
  double largest_stiffness(const SideFaces& side) const override {
    constexpr double largest_factor = 1e4;
    return std::max(factor_, largest_factor) * unit(side);
  }
  PointRows rows(const SideFaces& side, const MotionRows& first, const MotionRows& second,
                 const Vec2&) const final {
    return jump_rows(side.normal, first.displacement, second.displacement);
  }
  Vec2 stress_weights(const SideFaces&) const final { return Vec2::Zero(); }

 protected:
  /// What a factor counts in [F/L³].
  virtual double unit(const SideFaces& side) const { return spring_unit(side); }

 private:
  double factor_;
};

}  // namespace dda
