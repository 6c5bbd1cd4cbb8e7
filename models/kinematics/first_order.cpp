#include "models/kinematics/first_order.hpp"

namespace dda {

Mat26 displacement_rows(const Vec2& offset) {
  const double x = offset.x(), y = offset.y();
  Mat26 t;
  t << 1, 0, -y, x, 0, y / 2,  //
      0, 1, x, 0, y, x / 2;
  return t;
}

Mat36 strain_rows() {
  Mat36 e = Mat36::Zero();
  e.rightCols<3>().setIdentity();
  return e;
}

Eigen::Matrix<double, 2, 3> traction_rows(const Vec2& n) {
  const Vec2 s(-n.y(), n.x());
  Eigen::Matrix<double, 2, 3> rows;
  rows << n.x() * n.x(), n.y() * n.y(), 2 * n.x() * n.y(),  //
      s.x() * n.x(), s.y() * n.y(), s.x() * n.y() + s.y() * n.x();
  return rows;
}

}  // namespace dda
