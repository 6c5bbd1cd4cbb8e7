#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "continuation/linear/cholesky/half_solver.hpp"
#include "continuation/linear/dense/two_by_two.hpp"
#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// Points whose half columns are made together: more share no more of their way through the factor.
inline constexpr std::size_t largest_group = 4;

/// Runs of points between the multiples of a number.
std::vector<std::span<const std::size_t>> neighbours(std::span<const std::size_t> points, std::size_t most);

/// Rows Bᵀ of some points, by the blocks and nodes they act on; entry i of `points` has the columns 2 i and 2 i + 1.
std::vector<HalfSolver::Entry> entries_of(const Equilibrium& equilibrium,
                                          std::span<const std::size_t> points);

}  // namespace dda
