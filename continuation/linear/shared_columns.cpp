#include "continuation/linear/shared_columns.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "continuation/linear/column_groups.hpp"
#include "framework/base/threads.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;

/// Half of Z as HalfColumns has it, Y = L⁻¹ Uᵀ: rows of the strips with their ranks, those between the strips here.
class SharedColumns final : public UpdateColumns {
 public:
  SharedColumns(const Equilibrium& equilibrium, const SharedMatrix& matrix, std::size_t batch)
      : equilibrium_(equilibrium), matrix_(matrix), group_size_(std::min(batch, largest_group)) {
    matrix_.forget_groups();
  }

  void add(std::span<const std::size_t> points, Matrix& g) override {
    const std::size_t first = groups_.size(), first_place = places_.size();
    std::vector<SharedMatrix::Entries> entries;
    for (const std::span<const std::size_t> group : neighbours(points, group_size_)) {
      for (std::size_t i = 0; i < group.size(); ++i) places_.push_back({groups_.size(), pair_at(i)});
      groups_.push_back({places_.size() - group.size(), pair_at(group.size()), {}});
      entries.push_back(entries_of(equilibrium_, group));
    }
    const Eigen::Index all = pair_at(places_.size()), old = pair_at(first_place);
    g.block(0, old, all, all - old).setZero();
    std::vector<BetweenColumns> between = matrix_.add_groups(
        entries, [&](std::size_t left, std::size_t right, std::span<const double> product) {
          block_of(left, right, g) +=
              Eigen::Map<const Matrix>(product.data(), groups_[left].columns, groups_[right].columns);
        });
    for (std::size_t i = 0; i < between.size(); ++i) groups_[first + i].between = std::move(between[i]);
    parallel_for(groups_.size(), 1, [&](std::size_t left) {
      for (std::size_t right = std::max(left, first); right < groups_.size(); ++right) couple(left, right, g);
    });
  }

  void begin_anew() override {
    groups_.clear();
    places_.clear();
    matrix_.forget_groups();
  }

  /// A border needs half solutions one at a time.
  bool follow(std::span<const std::size_t>, std::span<const std::size_t>, std::size_t, Matrix&) override {
    return false;
  }

  void subtract(std::span<const std::size_t> places, const Matrix& shares,
                std::span<const std::span<double>> solutions) override {
    std::vector<std::vector<SharedMatrix::Multiple>> sums;
    for (Eigen::Index c = 0; c < shares.cols(); ++c) sums.push_back(multiples(places, shares.col(c)));
    const std::vector<double> all = matrix_.complete(sums, sum_between(sums));
    const std::size_t n = matrix_.num_rows();
    num_solves_ += solutions.size();
    for (std::size_t c = 0; c < solutions.size(); ++c)
      for (std::size_t i = 0; i < n; ++i) solutions[c][i] -= all[c * n + i];
  }

  Eigen::VectorXd along(const Functional& gauge) override {
    SharedMatrix::Entries entries;
    for (const auto& [block, row] : gauge.rows) {
      entries.push_back({block, Mat62::Zero()});
      entries.back().rows.col(0) = row;
    }
    Eigen::VectorXd out = Eigen::VectorXd::Zero(pair_at(places_.size()));
    if (entries.empty()) return out;
    const auto rows_of = [&](std::size_t group) {
      return out.segment(pair_at(groups_[group].first), groups_[group].columns);
    };
    const BetweenColumns between =
        matrix_.along(entries, [&](std::size_t group, std::size_t, std::span<const double> product) {
          rows_of(group) += Eigen::Map<const Eigen::VectorXd>(product.data(), std::ssize(product));
        });
    for (std::size_t group = 0; group < groups_.size(); ++group)
      Between::add_product(groups_[group].between, between, rows_of(group));
    return out;
  }

  bool product_is_cheap() const override { return true; }
  std::size_t most_at_once() const override { return std::numeric_limits<std::size_t>::max(); }

 private:
  struct Group {
    std::size_t first;  ///< place
    Eigen::Index columns;
    BetweenColumns between;
  };
  /// Where the columns of a point are.
  struct Place {
    std::size_t group;
    Eigen::Index column;
  };

  Eigen::Block<Matrix> block_of(std::size_t left, std::size_t right, Matrix& g) const {
    return g.block(pair_at(groups_[left].first), pair_at(groups_[right].first), groups_[left].columns,
                   groups_[right].columns);
  }

  /// Adds what two groups have in common between the strips.
  void couple(std::size_t left, std::size_t right, Matrix& g) const {
    Between::add_product(groups_[left].between, groups_[right].between, block_of(left, right, g));
    const Matrix common = block_of(left, right, g);
    block_of(right, left, g) = common.transpose();
  }

  /// Shares of neighbouring places of a group together.
  std::vector<SharedMatrix::Multiple> multiples(std::span<const std::size_t> places,
                                                const Eigen::VectorXd& share) const {
    std::vector<SharedMatrix::Multiple> out;
    for (std::size_t a = 0, end; a < places.size(); a = end) {
      const Place& at = places_[places[a]];
      for (end = a + 1; end < places.size() && places[end] == places[a] + (end - a) &&
                        places_[places[end]].group == at.group;)
        ++end;
      out.push_back({at.group, at.column, share.segment(pair_at(a), pair_at(end - a))});
    }
    return out;
  }

  BetweenColumns sum_between(std::span<const std::vector<SharedMatrix::Multiple>> sums) const {
    BetweenColumns out = matrix_.between().zero(0, std::ssize(sums));
    for (std::size_t c = 0; c < sums.size(); ++c)
      for (const SharedMatrix::Multiple& multiple : sums[c]) {
        const BetweenColumns& of = groups_[multiple.group].between;
        for (std::size_t i = 0; i < of.at.size(); ++i)
          out.at[of.first + i].col(static_cast<Eigen::Index>(c)).noalias() +=
              of.at[i].middleCols(multiple.column, multiple.factors.size()) * multiple.factors;
      }
    return out;
  }

  const Equilibrium& equilibrium_;
  const SharedMatrix& matrix_;
  const std::size_t group_size_;
  std::vector<Group> groups_;
  std::vector<Place> places_;
};

}  // namespace

std::unique_ptr<UpdateColumns> shared_columns(const Equilibrium& equilibrium, const SharedMatrix& matrix,
                                              std::size_t batch) {
  return std::make_unique<SharedColumns>(equilibrium, matrix, batch);
}

}  // namespace dda
