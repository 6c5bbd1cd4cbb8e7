#pragma once

#include <Eigen/Core>
#include <vector>

#include "continuation/linear/dense/dense_lu.hpp"
#include "framework/base/vec2.hpp"

namespace dda {

/// M⁻¹ of a matrix that is the unit matrix but for some columns and its last row, and that changes by
/// matrices of rank one. A factorisation costs as much as one of the size of those columns.
class ChangingInverse {
 public:
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  /// `columns` of M at `places`, which ascend and end with the last one; `last_row` of M elsewhere. False
  /// when M is singular.
  bool factor(const Matrix& columns, std::vector<Eigen::Index> places, Vector last_row);
  Vector solve(const Vector& b) const;
  /// Adds u vᵀ, v at two rows only; the factor by which the determinant changes.
  double add(const Vector& u, Eigen::Index at, const Vec2& v);
  /// Brings a solution before the last change up to it.
  void update(Vector& x) const;
  std::size_t num_changes() const { return changes_.size(); }
  /// Of the columns that are factorised.
  std::size_t size() const { return places_.size(); }

 private:
  struct Change {
    Vector column;
    Eigen::Index at;
    Vec2 v;
    double ratio;
    double along(const Vector& x) const { return v.dot(x.segment<2>(at)); }
  };

  std::vector<Eigen::Index> places_, others_;
  Matrix columns_;  ///< at `others_` alone
  Vector last_row_;
  DenseLu lu_;  ///< of the rows at `places_`, what the others have to do with the last one eliminated
  std::vector<Change> changes_;
};

}  // namespace dda
