#include "models/kinematics/second_order.hpp"

namespace dda {

Mat26 gradient_displacement_rows(const Vec2& offset, double size) {
  const double xx = offset.x() * offset.x() / 2, yy = offset.y() * offset.y() / 2,
               xy = offset.x() * offset.y();
  Mat26 out;
  out << xx, xy, -yy, 0, 0, yy,  //
      0, -xx, xy, yy, xx, 0;
  return out / size;
}

Mat36 gradient_strain_rows(const Vec2& offset, double size) {
  Mat36 out = Mat36::Zero();
  for (int i = 0; i < 3; ++i) out.block<1, 2>(i, 2 * i) = offset.transpose() / size;
  return out;
}

Vec6 gradient_rotation_row(const Vec2& offset, double size) {
  Vec6 out;
  out << 0, -offset.x(), offset.y(), 0, offset.x() / 2, -offset.y() / 2;
  return out / size;
}

Mat6 gradient_stiffness(const Mat3& stiffness, const Mat2& second_moments, double area) {
  Mat6 out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.block<2, 2>(2 * i, 2 * j) = stiffness(i, j) / area * second_moments;
  return out;
}

}  // namespace dda
