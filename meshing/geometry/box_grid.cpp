#include "meshing/geometry/box_grid.hpp"

namespace dda {

BoxGrid::BoxGrid(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  choose_cells();
  first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Box& box : boxes_) for_each_cell(box, [&](Cell c) { ++first_[number(c.column, c.row) + 1]; });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  members_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    for_each_cell(boxes_[i], [&](Cell c) { members_[next[number(c.column, c.row)]++] = i; });
}

/// Cells about as large as the mean box, at most about two per box.
void BoxGrid::choose_cells() {
  double mean = 0;
  for (const Box& box : boxes_) {
    all_.include(box.low);
    all_.include(box.high);
    mean += box.size() / static_cast<double>(boxes_.size());
  }
  if (boxes_.empty()) all_ = {Vec2::Zero(), Vec2::Zero()};
  const Vec2 extent = all_.high - all_.low;
  const double count = 2.0 * static_cast<double>(std::max<std::size_t>(boxes_.size(), 1));
  step_ = std::max({mean, std::sqrt(extent.prod() / count), extent.maxCoeff() / count});
  if (!(step_ > 0)) step_ = 1;
  columns_ = static_cast<int>(extent.x() / step_) + 1;
  rows_ = static_cast<int>(extent.y() / step_) + 1;
}

BoxGrid::Cell BoxGrid::cell_of(const Vec2& x) const {
  const Vec2 at = (x - all_.low) / step_;
  return {static_cast<int>(std::clamp(at.x(), 0.0, columns_ - 1.0)),
          static_cast<int>(std::clamp(at.y(), 0.0, rows_ - 1.0))};
}

}  // namespace dda
