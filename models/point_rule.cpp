#include "models/point_rule.hpp"

#include <cmath>

namespace dda {

PointsOfSide two_gauss_points() {
  const double g = 0.5 / std::sqrt(3.0);
  return {{0.5 - g, 0.5}, {0.5 + g, 0.5}};
}

PointsOfSide three_gauss_points() {
  const double g = 0.5 * std::sqrt(0.6);
  return {{0.5 - g, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + g, 5.0 / 18}};
}

PointsOfSide points_of_side(PointRule rule) {
  switch (rule) {
    case PointRule::vertices:
      return {{0.0, 0.5}, {1.0, 0.5}};
    case PointRule::midpoint:
      return {{0.5, 1.0}};
    case PointRule::gauss:
    case PointRule::gauss_2:
      break;
  }
  return two_gauss_points();
}

bool integrates_linear_stress(PointRule rule) {
  return rule == PointRule::gauss || rule == PointRule::gauss_2;
}

}  // namespace dda
