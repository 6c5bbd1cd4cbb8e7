#include "continuation/contact/contact_matrix.hpp"

#include <cmath>
#include <utility>

#include "continuation/linear/dense/two_by_two.hpp"

namespace dda {

bool ContactMatrix::move_to(const ContactProblem& problem, const std::vector<Mat2>& changes) {
  if (!has_factors()) return factor(problem, changes);
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (changes[i] != changes_[i]) moved.push_back(i);
  constexpr std::size_t per_change = 50;  // columns with which a factorisation costs as much as a change
  if (2 * moved.size() > inverse_.size() / per_change) return factor(problem, changes);
  for (const std::size_t i : moved) {
    const Mat2 by = changes[i] - changes_[i];
    for (int column = 0; column < 2; ++column)
      if (!by.col(column).isZero(0)) add(problem, {i, by.col(column), Vec2::Unit(column), changes[i]});
    if (is_worn()) return factor(problem, changes);
  }
  return true;
}

bool ContactMatrix::factor(const ContactProblem& problem, const std::vector<Mat2>& changes) {
  std::vector<std::size_t> points;
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i].isZero(0)) continue;
    points.push_back(i);
    places.insert(places.end(), {pair_at(i), pair_at(i) + 1});
  }
  const Eigen::Index last = pair_at(changes.size());
  places.push_back(last);
  Eigen::MatrixXd columns(last + 1, std::ssize(places));
  for (std::size_t a = 0; a < points.size(); ++a) {
    const Eigen::Index at = pair_at(points[a]);
    auto pair = columns.middleCols<2>(pair_at(a));
    pair = problem.couplings.middleCols<2>(at).lazyProduct(changes[points[a]]);
    pair.middleRows<2>(at) += Mat2::Identity();
    pair.row(last) += problem.control.segment<2>(at).transpose();
  }
  columns.rightCols(1) << -problem.live, problem.control[last];
  const bool is_regular = inverse_.factor(columns, std::move(places), problem.control);
  is_nearly_singular_ = false;
  ++num_factorisations_;
  changes_ = is_regular ? changes : std::vector<Mat2>();
  return is_regular;
}

double ContactMatrix::add(const ContactProblem& problem, const RankOne& change) {
  changes_[change.point] = change.sum;
  ++num_changes_;
  constexpr double singular = 1e-11;
  const auto columns = problem.couplings.middleCols<2>(pair_at(change.point));
  const double ratio = inverse_.add(columns.lazyProduct(change.u), pair_at(change.point), change.v);
  is_nearly_singular_ = is_nearly_singular_ || !(std::abs(ratio) >= singular);
  return ratio;
}

bool ContactMatrix::is_worn() const {
  constexpr std::size_t most_changes = 100;
  return is_nearly_singular_ || inverse_.num_changes() >= most_changes;
}

}  // namespace dda
