// A linear system whose structure gets more unknowns and points, and what a restart makes of it.
#include <algorithm>
#include <numeric>

#include "continuation/linear/linear_system.hpp"

namespace dda {

void LinearSystem::follow(const Growth& growth) {
  if (!grow(growth)) begin_anew();
}

void LinearSystem::begin_anew() {
  slot_.assign(equilibrium_.num_active(), -1);
  base_.clear();
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p)
    base_.emplace_back(equilibrium_.point(p).intact_stiffness().asDiagonal());
  if (!factor_base()) throw InputError({}, "the stiffness matrix is singular; check supports and materials");
  updates_softening_ = update_ == Update::low_rank && solver_.halves();
}

/// The base stays where all cuts are there that it was factorised with, and those of the border up to the first
/// growth that has been taken back. Unknown multipliers, which come behind the jumps, are in the way.
bool LinearSystem::grow(const Growth& growth) {
  if (update_ == Update::refactorise || general_ || !growth.keeps_stiffness ||
      equilibrium_.num_unknown_multipliers() > 0 || grown_.front().cuts > growth.same_cuts)
    return false;
  while (grown_.back().cuts > growth.same_cuts) grown_.pop_back();
  const std::size_t kept = grown_.back().nodes - grown_.front().nodes;
  std::vector<Mat2> base = growth.of_points(base_);
  for (std::size_t p = 0; p < base.size(); ++p)
    if (!growth.points[p]) base[p] = equilibrium_.point(p).intact_stiffness().asDiagonal();
  base_ = std::move(base);
  tangent_ = base_;
  const auto scope = timings_->measure("growth");
  bool is_intact = true;
  for (std::size_t p = 0; p < base_.size() && is_intact; ++p)
    is_intact = base_[p] == Mat2(equilibrium_.point(p).intact_stiffness().asDiagonal());
  if (!solver_.grow(is_intact ? equilibrium_.intact() : matrix_with(base_), kept)) return false;
  grown_.push_back({equilibrium_.num_cuts(), equilibrium_.num_nodes()});
  number_anew(growth, kept);
  return true;
}

/// Nodes of the border before are still there up to some number. Kept solutions are solved for again: what is put
/// together from them is no better than they are.
void LinearSystem::number_anew(const Growth& growth, std::size_t nodes) {
  std::vector<std::optional<std::size_t>> now(slot_.size());
  for (std::size_t p = 0; p < growth.points.size(); ++p)
    if (growth.points[p]) now[*growth.points[p]] = p;
  std::vector<std::size_t> kept, points;
  for (std::size_t i = 0; i < updated_.size(); ++i)
    if (now[updated_[i]]) {
      kept.push_back(i);
      points.push_back(*now[updated_[i]]);
    }
  updated_ = std::move(points);
  if (batch_ != batch() || !columns_->follow(kept, updated_, nodes, g_)) {
    updated_.clear();
    num_solves_ += columns_->num_solves();
    columns_ = update_columns(equilibrium_, solver_, batch());
  }
  batch_ = batch();
  takes_all_ = are_few();
  active_.clear();
  gauges_.clear();
  slot_.assign(equilibrium_.num_active(), -1);
  for (std::size_t i = 0; i < updated_.size(); ++i) slot_[updated_[i]] = static_cast<int>(i);
  for (Kept* load : {&reference_, &dead_}) *load = {std::move(load->right)};
}

std::size_t LinearSystem::num_border_columns() const {
  constexpr std::size_t of_jump = 3;
  return of_jump * solver_.border().num_nodes();
}

/// Points of a side or a cut mostly crack together; what belongs together must come and go together.
std::size_t LinearSystem::batch() const {
  constexpr std::size_t of_side = 2, of_many = 4;
  if (!solver_.halves()) return of_many;
  bool has_cuts = false, are_pairs = equilibrium_.num_active() % of_side == 0;
  for (std::size_t p = 0; p + 1 < equilibrium_.num_active(); p += of_side) {
    const InterfacePoint &one = equilibrium_.point(p), &other = equilibrium_.point(p + 1);
    has_cuts = has_cuts || one.cut || other.cut;
    are_pairs = are_pairs && one.side == other.side && one.cut == other.cut;
  }
  return has_cuts && !are_pairs ? 1 : of_side;
}

bool LinearSystem::are_few() const {
  return solver_.halves() && !equilibrium_.has_separate_bodies() &&
         2 * equilibrium_.num_active() <= most_columns();
}

std::vector<std::size_t> LinearSystem::grown() const {
  std::vector<std::size_t> out;
  std::ranges::transform(grown_, std::back_inserter(out), &Grown::cuts);
  return out;
}

bool LinearSystem::restore(std::span<const Mat2> base) {
  settle_pending();
  base_.assign(base.begin(), base.end());
  return factor_base();
}

void LinearSystem::restore_columns(std::span<const std::size_t> updated) {
  const std::size_t first = updated_.size();
  for (const std::size_t point : updated) {
    slot_[point] = static_cast<int>(updated_.size());
    updated_.push_back(point);
  }
  make_columns_from(first);
}

/// Computes Z for the batches of the points that have none, and their couplings in G with every point before.
void LinearSystem::add_columns(std::span<const std::size_t> points) {
  const std::size_t first = updated_.size();
  std::vector<std::size_t> all;
  if (takes_all_ && !points.empty()) {
    all.resize(equilibrium_.num_active());
    std::iota(all.begin(), all.end(), std::size_t{0});
    points = all;
  }
  for (const std::size_t point : points) {
    if (slot_[point] >= 0) continue;
    const std::size_t begin = point / batch_ * batch_;
    const std::size_t end = std::min(begin + batch_, equilibrium_.num_active());
    for (std::size_t p = begin; p < end; ++p) {
      slot_[p] = static_cast<int>(updated_.size());
      updated_.push_back(p);
    }
  }
  make_columns_from(first);
}

void LinearSystem::make_columns_from(std::size_t first) {
  if (updated_.size() == first) return;
  const auto scope = timings_->measure("columns");
  const auto needed = static_cast<Eigen::Index>(2 * updated_.size());
  if (g_.rows() < needed) {
    const auto most = static_cast<Eigen::Index>(most_columns() + 2 * batch_);
    const Eigen::Index size = std::max(needed, std::min(2 * needed, most));
    g_.conservativeResize(size, size);
  }
  columns_->add(std::span<const std::size_t>(updated_).subspan(first), g_);
}

}  // namespace dda
