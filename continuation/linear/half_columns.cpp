// Columns of an update as half solutions.
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "continuation/linear/column_groups.hpp"
#include "continuation/linear/direct/bordered_solver.hpp"
#include "continuation/linear/update_columns.hpp"
#include "framework/base/threads.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;

/// Half of Z: with K = L Lᵀ and Y = L⁻¹ Uᵀ,
///
///     G = Yᵀ Y,     Z s = L⁻ᵀ Y s
///
/// A column costs the way from its blocks to the root of the elimination tree instead of all of L, and a
/// product half a solution. Where K has a border Y has rows more, and what is there stays: G is corrected by the
/// products of these rows, three for each jump.
class HalfColumns final : public UpdateColumns {
 public:
  HalfColumns(const Equilibrium& equilibrium, const BorderedSolver& solver, std::size_t batch)
      : equilibrium_(equilibrium),
        solver_(*solver.halves()),
        border_(solver.border()),
        group_size_(std::min(batch, largest_group)) {}

  void add(std::span<const std::size_t> points, Matrix& g) override {
    const std::size_t first = groups_.size();
    const auto new_groups = neighbours(points, group_size_);
    for (const std::span<const std::size_t> group : new_groups) {
      for (std::size_t i = 0; i < group.size(); ++i)
        places_.push_back({groups_.size(), 2 * static_cast<Eigen::Index>(i)});
      groups_.push_back({places_.size() - group.size(), {}, {}});
    }
    parallel_for(new_groups.size(), 1, [&](std::size_t i) {
      const std::vector<HalfSolver::Entry> entries = entries_of(equilibrium_, new_groups[i]);
      Group& group = groups_[first + i];
      group.y = border_.half_solve(entries);
      border_.extend(group.y, entries, group.border);
    });
    if (border_.num_nodes() > 0) without_border_.conservativeResize(g.rows(), g.cols());
    constexpr std::size_t at_once = 8;  // the half solutions of so many stay in the cache
    for (std::size_t begin = first; begin < groups_.size(); begin += at_once) {
      const std::size_t end = std::min(begin + at_once, groups_.size());
      parallel_for(end, 1, [&](std::size_t left) {
        for (std::size_t right = std::max(left, begin); right < end; ++right) couple(left, right, g);
      });
    }
  }

  void begin_anew() override {
    groups_.clear();
    places_.clear();
  }

  bool follow(std::span<const std::size_t> kept, std::span<const std::size_t> points, std::size_t nodes,
              Matrix& g) override {
    const auto rows = static_cast<Eigen::Index>(block_unknowns * nodes), before = border_rows();
    const auto all = pair_at(places_.size());
    if (before == 0) without_border_ = g;
    if (before > rows) g.topLeftCorner(all, all) = without_border_.topLeftCorner(all, all);
    if (kept.size() < places_.size()) {
      keep(kept);
      keep(kept, g);
      keep(kept, without_border_);
    }
    const auto first = static_cast<std::size_t>(before > rows ? 0 : before / block_unknowns);
    parallel_for(groups_.size(), 1, [&](std::size_t i) {
      Group& group = groups_[i];
      if (group.border.rows() > rows) group.border.conservativeResize(rows, Eigen::NoChange);
      border_.extend(group.y, entries_of(equilibrium_, points.subspan(group.first, size_of(i))),
                     group.border);
    });
    parallel_for(groups_.size(), 1, [&](std::size_t left) {
      for (std::size_t right = left; right < groups_.size(); ++right) correct(left, right, first, g);
    });
    return true;
  }

  void subtract(std::span<const std::size_t> places, const Matrix& shares,
                std::span<const std::span<double>> solutions) override {
    const std::size_t n = equilibrium_.num_unknowns() - block_unknowns * border_.num_nodes();
    std::vector<double> sums(solutions.size() * n, 0.0);
    Matrix jumps =
        Matrix::Zero(static_cast<Eigen::Index>(block_unknowns * border_.num_nodes()), shares.cols());
    for (std::size_t c = 0; c < solutions.size(); ++c) {
      const std::span<double> sum = std::span(sums).subspan(c * n, n);
      Eigen::VectorXd jump = jumps.col(static_cast<Eigen::Index>(c));
      add_up(places, shares.col(static_cast<Eigen::Index>(c)), sum, jump);
      border_.complete(sum, jump);
      jumps.col(static_cast<Eigen::Index>(c)) = jump;
    }
    solver_.complete(sums, static_cast<int>(solutions.size()));
    num_solves_ += solutions.size();
    for (std::size_t c = 0; c < solutions.size(); ++c) {
      for (std::size_t i = 0; i < n; ++i) solutions[c][i] -= sums[c * n + i];
      for (std::size_t i = n; i < solutions[c].size(); ++i)
        solutions[c][i] -= jumps(static_cast<Eigen::Index>(i - n), static_cast<Eigen::Index>(c));
    }
  }

  Eigen::VectorXd along(const Functional& gauge) override {
    std::vector<HalfSolver::Entry> entries;
    for (const auto& [block, row] : gauge.rows) {
      entries.push_back({block, Mat62::Zero()});
      entries.back().rows.col(0) = row;
    }
    Eigen::VectorXd out = Eigen::VectorXd::Zero(2 * std::ssize(places_));
    if (entries.empty()) return out;
    Group of_gauge{0, border_.half_solve(entries), {}};
    of_gauge.y.columns = std::max<Eigen::Index>(of_gauge.y.columns, 2);  // of jumps alone
    border_.extend(of_gauge.y, entries, of_gauge.border);
    constexpr std::size_t products_at_once = 8;
    parallel_for(groups_.size(), products_at_once, [&](std::size_t g) {
      Matrix common = solver_.product(groups_[g].y, of_gauge.y);
      add_border_product(groups_[g].border, of_gauge.border, 0, common);
      out.segment(pair_at(groups_[g].first), common.rows()) = common.col(0);
    });
    return out;
  }

  bool product_is_cheap() const override { return true; }
  std::size_t most_at_once() const override { return std::numeric_limits<std::size_t>::max(); }

 private:
  struct Group {
    std::size_t first;  ///< place
    HalfSolution y;
    Matrix border;  ///< its rows in the border, below one another
  };
  /// Where the columns of a point are.
  struct Place {
    std::size_t group;
    Eigen::Index column;
  };

  std::size_t size_of(std::size_t group) const {
    return static_cast<std::size_t>(groups_[group].y.columns / 2);
  }
  Eigen::Index border_rows() const { return groups_.empty() ? 0 : groups_.front().border.rows(); }

  /// Groups all of whose places stay.
  void keep(std::span<const std::size_t> kept) {
    std::vector<Group> groups;
    std::vector<Place> places;
    for (std::size_t i = 0; i < kept.size();) {
      Group& group = groups_[places_[kept[i]].group];
      const auto size = static_cast<std::size_t>(group.y.columns / 2);
      for (std::size_t c = 0; c < size; ++c)
        places.push_back({groups.size(), 2 * static_cast<Eigen::Index>(c)});
      groups.push_back(std::move(group));
      groups.back().first = i;
      i += size;
    }
    groups_ = std::move(groups);
    places_ = std::move(places);
  }

  static void keep(std::span<const std::size_t> kept, Matrix& g) {
    for (std::size_t i = 0; i < kept.size(); ++i)
      for (std::size_t j = 0; j < kept.size(); ++j) {
        const Mat2 block = g.block<2, 2>(pair_at(kept[i]), pair_at(kept[j]));
        g.block<2, 2>(pair_at(i), pair_at(j)) = block;
      }
  }

  /// G of two groups.
  void couple(std::size_t left, std::size_t right, Matrix& g) {
    const Matrix common = solver_.product(groups_[left].y, groups_[right].y);
    put(left, right, common, g);
    if (border_.num_nodes() == 0) return;
    put(left, right, common, without_border_);
    correct(left, right, 0, g);
  }

  /// Adds to G what the nodes of the border give, from one on.
  void correct(std::size_t left, std::size_t right, std::size_t first_node, Matrix& g) const {
    const Group &a = groups_[left], &b = groups_[right];
    Matrix common = g.block(pair_at(a.first), pair_at(b.first), a.y.columns, b.y.columns);
    add_border_product(a.border, b.border, first_node, common);
    put(left, right, common, g);
  }

  void put(std::size_t left, std::size_t right, const Matrix& common, Matrix& g) const {
    const Eigen::Index row = pair_at(groups_[left].first), column = pair_at(groups_[right].first);
    g.block(column, row, common.cols(), common.rows()) = common.transpose();
    g.block(row, column, common.rows(), common.cols()) = common;
  }

  /// Y s, and its rows in the border.
  void add_up(std::span<const std::size_t> places, const Eigen::VectorXd& share, std::span<double> sum,
              Eigen::VectorXd& jumps) const {
    for (std::size_t a = 0, end; a < places.size(); a = end) {
      const Place& at = places_[places[a]];
      for (end = a + 1; end < places.size() && places[end] == places[a] + (end - a) &&
                        places_[places[end]].group == at.group;)
        ++end;
      const Eigen::VectorXd here = share.segment(pair_at(a), pair_at(end - a));
      solver_.add(groups_[at.group].y, at.column, here, sum);
      jumps += groups_[at.group].border.middleCols(at.column, here.size()) * here;
    }
  }

  const Equilibrium& equilibrium_;
  const HalfSolver& solver_;
  const Border& border_;
  /// Points whose columns are made together: their ways are the same but for the beginning, and L is read once
  /// for all of them. No more than are always added together, or last digits would hang on what was added when.
  const std::size_t group_size_;
  std::vector<Group> groups_;
  std::vector<Place> places_;
  Matrix without_border_;  ///< G of A alone, where there is a border
};

}  // namespace

std::unique_ptr<UpdateColumns> half_columns(const Equilibrium& equilibrium, const BorderedSolver& solver,
                                            std::size_t batch) {
  return std::make_unique<HalfColumns>(equilibrium, solver, batch);
}

}  // namespace dda
