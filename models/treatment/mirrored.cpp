#include "models/treatment/mirrored.hpp"

namespace dda {

MotionRows mirrored(const MotionRows& rows, const Vec2& normal) {
  const Mat2 m = Mat2::Identity() - 2 * normal * normal.transpose();
  const double a = m(0, 0), b = m(0, 1), c = m(1, 1);
  Mat3 strain;                    // of (εx, εy, γxy)
  strain << a * a, b * b, a * b,  //
      b * b, c * c, b * c,        //
      2 * a * b, 2 * b * c, a * c + b * b;
  return {m * rows.displacement, strain * rows.strain};
}

}  // namespace dda
