#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace dda {

/// The numbers below n in sets that are merged: a forest, whose ways are halved where they are gone.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Which one stands for the set of i: the lowest, unless `merge_into` has said otherwise.
  std::size_t representative(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void merge(std::size_t i, std::size_t j) {
    const auto [low, high] = std::minmax({representative(i), representative(j)});
    parent_[high] = low;
  }
  /// The representative of i stands for the set of j as well.
  void merge_into(std::size_t i, std::size_t j) { parent_[representative(j)] = representative(i); }
  std::size_t size() const { return parent_.size(); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace dda
