#include "continuation/linear/cholesky/elimination_order.hpp"

#include <algorithm>
#include <limits>

namespace dda {
namespace {

constexpr double worth_a_thread = 1e5;  // entries of L; they take some 50 µs
constexpr double tasks_at_least = 32;

using Level = std::vector<std::vector<int>>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Nodes whose branch exceeds a share of the work are the top: a chain of them is a task, and each fork
/// starts the next level. The branches below are the last level, neighbours together up to that share.
class Tasks {
 public:
  Tasks(std::span<const int> parent, std::span<const double> work, double share)
      : parent_(parent), share_(share), branch_(work.begin(), work.end()) {
    for (std::size_t s = 0; s < branch_.size(); ++s)
      if (parent[s] >= 0) branch_[index(parent[s])] += branch_[s];
    num_heavy_.assign(branch_.size(), 0);
    for (std::size_t s = 0; s < branch_.size(); ++s)
      if (parent[s] >= 0 && is_heavy(s)) ++num_heavy_[index(parent[s])];
    place_.resize(branch_.size());
    for (std::size_t s = branch_.size(); s-- > 0;)
      if (work[s] > 0) is_heavy(s) ? add_to_top(s) : add_below(s);
  }

  std::vector<Level> result() && {
    levels_.push_back(std::move(below_));
    return std::move(levels_);
  }

 private:
  bool is_heavy(std::size_t s) const { return branch_[s] > share_; }

  void add_to_top(std::size_t s) {
    is_run_ = false;
    const int above = parent_[s];
    Place& place = place_[s];
    if (above >= 0) place = place_[index(above)];
    if (above < 0 || num_heavy_[index(above)] > 1) {
      if (above >= 0) ++place.level;
      if (levels_.size() <= place.level) levels_.resize(place.level + 1);
      place.task = levels_[place.level].size();
      levels_[place.level].emplace_back();
    }
    levels_[place.level][place.task].push_back(static_cast<int>(s));
  }

  void add_below(std::size_t s) {
    const bool is_whole_branch = parent_[s] < 0 || is_heavy(index(parent_[s]));
    if (!is_run_ || (is_whole_branch && filled_ + branch_[s] > share_)) {
      below_.emplace_back();
      filled_ = 0;
    }
    if (is_whole_branch) filled_ += branch_[s];
    is_run_ = true;
    below_.back().push_back(static_cast<int>(s));
  }

  struct Place {
    std::size_t level = 0, task = 0;
  };

  const std::span<const int> parent_;
  const double share_;
  std::vector<double> branch_;  ///< work of each node with all below it
  std::vector<int> num_heavy_;  ///< children of the top
  std::vector<Place> place_;    ///< of the top
  std::vector<Level> levels_;
  Level below_;
  double filled_ = 0;    ///< work of the task that is being filled
  bool is_run_ = false;  ///< whether the node before was of that task, so that it may go on
};

}  // namespace

EliminationOrder::EliminationOrder(std::span<const int> parent, std::span<const double> work) {
  for (const double w : work) work_ += w;
  const double share = std::max(work_ / tasks_at_least, worth_a_thread);
  levels_ = Tasks(parent, work, share).result();
  if (work_ < 2 * worth_a_thread) grain_ = std::numeric_limits<std::size_t>::max() / 2;
}

}  // namespace dda
