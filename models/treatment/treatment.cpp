#include "models/treatment/treatment.hpp"

namespace dda {

PointRows jump_rows(const Vec2& normal, const Mat26& first, const Mat26& second) {
  Mat2 frame;
  frame << normal.x(), normal.y(), -normal.y(), normal.x();
  return {.first = -frame * first, .second = frame * second};
}

}  // namespace dda
