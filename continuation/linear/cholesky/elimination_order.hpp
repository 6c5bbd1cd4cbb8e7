#pragma once

#include <span>
#include <vector>

#include "framework/base/threads.hpp"

namespace dda {

/// The order in which a tree is walked from its root to its leaves by several threads: branches that do not
/// hang together are tasks of their own.
///
/// Nodes are numbered such that a parent comes after its children, and a subtree is one run of numbers. The
/// tasks follow from the tree and the work alone, not from the number of threads.
class EliminationOrder {
 public:
  EliminationOrder() = default;
  /// parent[s] > s of node s, −1 of a root; work[s] is its work in any unit, 0 of a node that is left out.
  EliminationOrder(std::span<const int> parent, std::span<const double> work);

  /// visit(s) for every node, each after its parent.
  template <class Visit>
  void from_the_root(Visit&& visit) const {
    for (const std::vector<std::vector<int>>& tasks : levels_)
      parallel_for(tasks.size(), grain_, [&](std::size_t task) {
        for (const int s : tasks[task]) visit(s);
      });
  }

  /// All work.
  double work() const { return work_; }

 private:
  std::vector<std::vector<std::vector<int>>> levels_;  ///< tasks of each level, independent of one another
  std::size_t grain_ = 1;
  double work_ = 0;
};

}  // namespace dda
