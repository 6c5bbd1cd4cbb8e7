#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "continuation/bodies/bonds.hpp"
#include "continuation/motion/energy/block_sum.hpp"

namespace dda {

/// Two bodies as a place below the diagonal, unless one is held; by their rows, −1 of a held one.
inline void add_pair(int i, int j, std::vector<BlockSum::Pair>& out) {
  if (i >= 0 && j >= 0 && i != j)
    out.emplace_back(static_cast<std::uint32_t>(std::max(i, j)), static_cast<std::uint32_t>(std::min(i, j)));
}

/// Puts matrices of pairs of bodies together; what belongs to held ones pulls at others where these go ways.
class Curvatures {
 public:
  Curvatures(const std::vector<int>& rows, const Poses& ways, BlockSum& sum)
      : rows_(rows),
        ways_(ways),
        sum_(sum),
        pull_(Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(sum.num_rows()))) {
    sum_.set_zero();
  }

  bool wants(std::size_t i, std::size_t j) const {
    return rows_[i] >= 0 && (rows_[j] >= 0 ? rows_[i] >= rows_[j] : !ways_.empty());
  }
  void add(std::size_t i, std::size_t j, const Mat6& m) {
    if (rows_[j] < 0)
      pull_.segment<6>(6 * rows_[i]) += m * ways_[j];
    else
      sum_.add(static_cast<std::size_t>(rows_[i]), static_cast<std::size_t>(rows_[j]), m);
  }
  /// The same with a bᵀ.
  void add(std::size_t i, std::size_t j, const Vec6& a, const Vec6& b) {
    if (rows_[j] < 0)
      pull_.segment<6>(6 * rows_[i]) += a * b.dot(ways_[j]);
    else
      sum_.add(static_cast<std::size_t>(rows_[i]), static_cast<std::size_t>(rows_[j]), a, b);
  }
  /// factor g gᵀ of what counts on two bodies.
  void add(const std::array<std::size_t, 2>& bodies, const std::array<Vec6, 2>& g, double factor) {
    if (factor == 0) return;
    for (std::size_t a = 0; a < 2; ++a) {
      const Vec6 scaled = factor * g[a];
      for (std::size_t b = 0; b < 2; ++b)
        if (wants(bodies[a], bodies[b])) add(bodies[a], bodies[b], scaled, g[b]);
    }
  }
  /// A share of that of a joint with the stiffness D, of a spring.
  void add(const Bond& bond, const BondState& at, const Mat2& stiffness, double share = 1) {
    const std::array<std::size_t, 2> bodies{bond.first, bond.second};
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b)
        if (wants(bodies[a], bodies[b]))
          add(bodies[a], bodies[b], share * stiffness_of(bond, at, stiffness, {a, b}));
  }
  void add(const MotionSpring& spring, double share = 1) {
    for (const auto& [i, row_i] : spring.rows)
      for (const auto& [j, row_j] : spring.rows)
        if (wants(i, j)) add(i, j, share * spring.stiffness * row_i * row_j.transpose());
  }
  Eigen::VectorXd take_pull() { return std::move(pull_); }

 private:
  const std::vector<int>& rows_;
  const Poses& ways_;
  BlockSum& sum_;
  Eigen::VectorXd pull_;
};

}  // namespace dda
