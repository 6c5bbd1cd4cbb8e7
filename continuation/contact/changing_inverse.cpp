#include "continuation/contact/changing_inverse.hpp"

#include <utility>

namespace dda {

bool ChangingInverse::factor(Matrix columns, std::vector<Eigen::Index> places, Vector last_row) {
  changes_.clear();
  columns_ = std::move(columns);
  places_ = std::move(places);
  last_row_ = std::move(last_row);
  for (const Eigen::Index place : places_) last_row_[place] = 0;
  Matrix square = columns_(places_, Eigen::all);
  square.bottomRows(1) -= last_row_.transpose() * columns_;
  return lu_.compute(std::move(square));
}

Eigen::VectorXd ChangingInverse::solve(const Vector& b) const {
  Vector right = b(places_);
  right[right.size() - 1] -= last_row_.dot(b);
  const Vector y = lu_.solve(std::move(right));
  Vector x = b - columns_ * y;
  x(places_) = y;
  for (const Change& change : changes_) x -= change.column * (change.along(x) / change.ratio);
  return x;
}

double ChangingInverse::add(const Vector& u, Eigen::Index at, const Vec2& v) {
  Change change{solve(u), at, v, 1};
  change.ratio = 1 + change.along(change.column);
  changes_.push_back(std::move(change));
  return changes_.back().ratio;
}

void ChangingInverse::update(Vector& x) const {
  const Change& last = changes_.back();
  x -= last.column * (last.along(x) / last.ratio);
}

}  // namespace dda
