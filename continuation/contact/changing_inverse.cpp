#include "continuation/contact/changing_inverse.hpp"

#include <utility>

namespace dda {

bool ChangingInverse::factor(const Matrix& columns, std::vector<Eigen::Index> places, Vector last_row) {
  changes_.clear();
  places_ = std::move(places);
  others_.clear();
  for (Eigen::Index i = 0, next = 0; i < columns.rows(); ++i)
    if (places_[static_cast<std::size_t>(next)] == i)
      ++next;
    else
      others_.push_back(i);
  columns_ = columns(others_, Eigen::all);
  last_row_ = last_row(others_);
  Matrix square = columns(places_, Eigen::all);
  square.bottomRows(1) -= last_row_.transpose() * columns_;
  return lu_.compute(std::move(square));
}

Eigen::VectorXd ChangingInverse::solve(const Vector& b) const {
  Vector right = b(places_), rest = b(others_);
  right[right.size() - 1] -= last_row_.dot(rest);
  const Vector y = lu_.solve(std::move(right));
  rest.noalias() -= columns_ * y;
  Vector x(b.size());
  x(places_) = y;
  x(others_) = rest;
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
