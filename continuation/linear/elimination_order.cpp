#include "continuation/linear/elimination_order.hpp"

#include <algorithm>
#include <limits>

namespace dda {
namespace {

constexpr double worth_a_thread = 1e5;  // entries; they take some 50 µs
constexpr double tasks_at_least = 32;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Work of each node with all below it.
std::vector<double> with_branches(std::span<const int> parent, std::span<const double> work) {
  std::vector<double> out(work.begin(), work.end());
  for (std::size_t s = 0; s < out.size(); ++s)
    if (parent[s] >= 0) out[index(parent[s])] += out[s];
  return out;
}

}  // namespace

/// Nodes whose branch exceeds a share of the work are the top: a chain of them is a task, and each fork
/// starts the next level. The branches below are the last level, neighbours together up to that share.
EliminationOrder::EliminationOrder(std::span<const int> parent, std::span<const double> work) {
  const std::vector<double> branch = with_branches(parent, work);
  for (const double w : work) work_ += w;
  if (work_ < 2 * worth_a_thread) grain_ = std::numeric_limits<std::size_t>::max() / 2;
  const double share = std::max(work_ / tasks_at_least, worth_a_thread);
  std::vector<int> num_heavy(parent.size(), 0);
  for (std::size_t s = 0; s < parent.size(); ++s)
    if (parent[s] >= 0 && branch[s] > share) ++num_heavy[index(parent[s])];
  std::vector<std::vector<int>> leaves;
  std::vector<std::pair<std::size_t, std::size_t>> place(parent.size());  // level and task of heavy nodes
  double filled = 0;
  bool is_run = false;  // whether the last visited node was a light one, so that the run goes on
  for (int s = static_cast<int>(parent.size()) - 1; s >= 0; --s) {
    if (work[index(s)] == 0) continue;
    const int above = parent[index(s)];
    if (branch[index(s)] <= share) {
      const bool starts_branch = above < 0 || branch[index(above)] > share;
      if (!is_run || (starts_branch && filled + branch[index(s)] > share)) {
        leaves.emplace_back();
        filled = 0;
      }
      if (starts_branch) filled += branch[index(s)];
      leaves.back().push_back(s);
      is_run = true;
      continue;
    }
    is_run = false;
    auto [level, task] = above < 0 ? std::pair<std::size_t, std::size_t>{0, 0} : place[index(above)];
    if (above < 0 || num_heavy[index(above)] > 1) {
      if (above >= 0) ++level;
      if (levels_.size() <= level) levels_.resize(level + 1);
      task = levels_[level].size();
      levels_[level].emplace_back();
    }
    levels_[level][task].push_back(s);
    place[index(s)] = {level, task};
  }
  levels_.push_back(std::move(leaves));
}

}  // namespace dda
