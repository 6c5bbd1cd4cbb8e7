#include "models/treatment/treatment.hpp"

namespace dda {

double spring_unit(const SideFaces& side) {
  const double modulus = 2 / (1 / side.first.modulus + 1 / side.second.modulus);
  return modulus / side.centroid_distance;
}

PointRows jump_rows(const Vec2& normal, const Mat26& first, const Mat26& second) {
  Mat2 frame;
  frame << normal.x(), normal.y(), -normal.y(), normal.x();
  return {.first = -frame * first, .second = frame * second};
}

}  // namespace dda
