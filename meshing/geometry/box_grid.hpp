#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshing/geometry/polygon.hpp"

namespace dda {

/// Which boxes touch, in time proportional to the number of boxes and of answers: a uniform grid.
///
/// A pair of boxes shares several grid cells; it is reported from the one that holds the low corner of
/// their intersection, so every pair comes once without being remembered.
class BoxGrid {
 public:
  explicit BoxGrid(std::vector<Box> boxes);

  /// Calls visit(i, j), i ≠ j, once for each pair of boxes that touch.
  template <class Visit>
  void for_each_pair(Visit visit) const;

  /// Calls visit(i) once for each box that touches `box`.
  template <class Visit>
  void for_each_hit(const Box& box, Visit visit) const;

 private:
  struct Cell {
    int column = 0, row = 0;
    bool operator==(const Cell&) const = default;
  };
  Cell cell_of(const Vec2& x) const;
  std::size_t number(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }
  bool reports(const Box& a, const Box& b, Cell cell) const {
    return a.touches(b) && cell_of(a.low.cwiseMax(b.low)) == cell;
  }
  void choose_cells();
  template <class Visit>
  void for_each_cell(const Box& box, Visit visit) const;

  std::vector<Box> boxes_;
  Box all_;
  double step_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_;    // start of each cell in members_
  std::vector<std::size_t> members_;  // boxes by cell
};

template <class Visit>
void BoxGrid::for_each_cell(const Box& box, Visit visit) const {
  const Cell low = cell_of(box.low), high = cell_of(box.high);
  for (int row = low.row; row <= high.row; ++row)
    for (int column = low.column; column <= high.column; ++column) visit(Cell{column, row});
}

template <class Visit>
void BoxGrid::for_each_pair(Visit visit) const {
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const std::size_t begin = first_[number(column, row)], end = first_[number(column, row) + 1];
      for (std::size_t k = begin; k < end; ++k)
        for (std::size_t l = k + 1; l < end; ++l)
          if (reports(boxes_[members_[k]], boxes_[members_[l]], {column, row}))
            visit(members_[k], members_[l]);
    }
}

template <class Visit>
void BoxGrid::for_each_hit(const Box& box, Visit visit) const {
  for_each_cell(box, [&](Cell cell) {
    const std::size_t c = number(cell.column, cell.row);
    for (std::size_t k = first_[c]; k < first_[c + 1]; ++k)
      if (reports(boxes_[members_[k]], box, cell)) visit(members_[k]);
  });
}

}  // namespace dda
