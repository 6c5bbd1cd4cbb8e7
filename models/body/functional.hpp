#pragma once

#include <span>
#include <utility>
#include <vector>

#include "framework/base/index.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// A linear scalar of the state, g(d, λ) = Σ rowᵀ d_block + per_load_factor · λ + constant:
/// a displacement, a relative displacement, a reaction, a load.
struct Functional {
  std::vector<std::pair<BlockId, Vec6>> rows;
  double per_load_factor = 0;
  double constant = 0;

  double value(std::span<const double> d, double load_factor) const {
    double sum = per_load_factor * load_factor + constant;
    for (const auto& [block, row] : rows)
      sum += row.dot(Eigen::Map<const Vec6>(d.data() + 6 * block.value()));
    return sum;
  }
  /// Adds scale · ∂g/∂d to a vector of length 6 · blocks.
  void add_gradient(double scale, std::span<double> out) const {
    for (const auto& [block, row] : rows) Eigen::Map<Vec6>(out.data() + 6 * block.value()) += scale * row;
  }
  /// this += scale · wᵀ d, w a vector of length 6 · blocks.
  void add_rows(double scale, std::span<const double> w) {
    for (std::size_t b = 0; 6 * b < w.size(); ++b)
      if (const Eigen::Map<const Vec6> row(w.data() + 6 * b); !row.isZero(0))
        rows.emplace_back(BlockId(b), scale * row);
  }
  /// this += scale · other.
  void add(double scale, const Functional& other) {
    for (const auto& [block, row] : other.rows) rows.emplace_back(block, scale * row);
    per_load_factor += scale * other.per_load_factor;
    constant += scale * other.constant;
  }
};

/// What a support or a driven spring exerts on the structure: a force [F], or where it holds a rotation a moment [F L].
struct Reaction : Functional {
  bool is_moment = false;
};

}  // namespace dda
