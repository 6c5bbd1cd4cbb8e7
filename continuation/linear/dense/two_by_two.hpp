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

/// The stiffness of a point in a base, or the intact one where next to none is left: blocks that are held by nothing there
/// would fly off in its solutions, and openings be told from their rounding.
inline Mat2 held_at_least(const Mat2& stiffness, const Mat2& intact) {
  constexpr double loose = 1e-3;
  const bool holds = (stiffness.diagonal().array() > loose * intact.diagonal().array()).all();
  return holds ? stiffness : intact;
}

}  // namespace dda
