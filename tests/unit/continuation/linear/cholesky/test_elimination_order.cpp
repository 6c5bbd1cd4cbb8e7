#include <gtest/gtest.h>

#include <random>

#include "continuation/linear/cholesky/elimination_order.hpp"

namespace dda {
namespace {

/// A tree in postorder: node s ends a subtree of the nodes before it.
struct Tree {
  std::vector<int> parent;
  std::vector<double> work;
};

void add_subtree(int size, std::mt19937& random, Tree& tree) {
  std::vector<int> children;
  for (int rest = size - 1; rest > 0;) {
    const int part = std::uniform_int_distribution(1, rest)(random);
    add_subtree(part, random, tree);
    children.push_back(static_cast<int>(tree.parent.size()) - 1);
    rest -= part;
  }
  for (const int child : children)
    tree.parent[static_cast<std::size_t>(child)] = static_cast<int>(tree.parent.size());
  tree.parent.push_back(-1);
  tree.work.push_back(std::uniform_real_distribution(1.0, 1e5)(random));
}

/// Two at each fork, `depth` forks above each other.
void add_dissection(int depth, Tree& tree) {
  int left = -1, right = -1;
  if (depth > 0) {
    add_dissection(depth - 1, tree);
    left = static_cast<int>(tree.parent.size()) - 1;
    add_dissection(depth - 1, tree);
    right = static_cast<int>(tree.parent.size()) - 1;
  }
  for (const int child : {left, right})
    if (child >= 0) tree.parent[static_cast<std::size_t>(child)] = static_cast<int>(tree.parent.size());
  tree.parent.push_back(-1);
  tree.work.push_back(2e4);
}

/// Checks that every node with work is visited once and after its parent.
void expect_right_order(const Tree& tree) {
  const EliminationOrder order(tree.parent, tree.work);
  std::vector<int> visits(tree.parent.size(), 0);
  order.from_the_root([&](int s) {
    const int above = tree.parent[static_cast<std::size_t>(s)];
    if (above >= 0) {
      EXPECT_EQ(visits[static_cast<std::size_t>(above)], 1) << "parent of " << s;
    }
    ++visits[static_cast<std::size_t>(s)];
  });
  for (std::size_t s = 0; s < visits.size(); ++s) EXPECT_EQ(visits[s], tree.work[s] > 0) << s;
}

TEST(EliminationOrder, VisitsEachNodeOnceAndAfterItsParent) {
  const int before = num_threads();
  std::mt19937 random(1);
  for (int threads = 1; threads <= 4; ++threads) {
    set_num_threads(threads);
    for (const int size : {1, 2, 50, 400})
      for (int repeat = 0; repeat < 5; ++repeat) {
        Tree forest;
        add_subtree(size, random, forest);
        add_subtree(size, random, forest);
        expect_right_order(forest);
      }
    Tree dissection;
    add_dissection(9, dissection);
    expect_right_order(dissection);
  }
  set_num_threads(before);
}

TEST(EliminationOrder, LeavesOutWhatHasNoWork) {
  Tree tree;
  add_dissection(8, tree);
  // The way of one leaf to the root.
  std::vector<double> work(tree.work.size(), 0.0);
  for (int s = 0; s >= 0; s = tree.parent[static_cast<std::size_t>(s)])
    work[static_cast<std::size_t>(s)] = 1e5;
  tree.work = work;
  expect_right_order(tree);
  EXPECT_EQ(EliminationOrder(tree.parent, tree.work).work(), 9e5);
}

TEST(EliminationOrder, OfNothingVisitsNothing) {
  const EliminationOrder order;
  order.from_the_root([](int) { FAIL(); });
}

}  // namespace
}  // namespace dda
