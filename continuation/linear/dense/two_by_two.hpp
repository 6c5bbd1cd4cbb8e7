#pragma once

#include "models/kinematics/first_order.hpp"

// What stands in pairs: the two components of each point in a vector of all, and their blocks of 2 × 2.
namespace dda {

/// First of the two rows, or columns, that belong to a point.
inline Eigen::Index pair_at(std::size_t point) { return 2 * static_cast<Eigen::Index>(point); }

inline auto pair_of(Eigen::VectorXd& v, std::size_t point) { return v.segment<2>(pair_at(point)); }
inline auto pair_of(const Eigen::VectorXd& v, std::size_t point) { return v.segment<2>(pair_at(point)); }

/// Equal but for rounding: what is left of a symmetric tangent beside its symmetric part is no update.
inline bool is_same(const Mat2& a, const Mat2& b) {
  constexpr double round_off = 1e-14;
  return (a - b).cwiseAbs().maxCoeff() <= round_off * b.cwiseAbs().maxCoeff();
}

inline Mat2 symmetric_part(const Mat2& a) { return 0.5 * (a + a.transpose()); }

}  // namespace dda
