#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "models/body/functional.hpp"
#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// Whole columns that are worth making at once: more are soon made again, and a factorisation is cheaper.
inline constexpr std::size_t most_whole_columns = 160;

class BorderedSolver;

/// Columns beyond which a new base is cheaper: the dense part of a few iterations, ⅔ r³ each, against one
/// factorisation of so many operations and the columns that a new base needs again. An operation of a small
/// sparse factorisation takes many times as long as one in a dense matrix.
std::size_t most_columns_beside(double factor_flops);

/// Numbers of whole columns that are kept; beyond it (256 MiB) a product is a solution.
inline constexpr std::size_t most_kept_numbers = std::size_t{1} << 25;

/// Columns of Z = K⁻¹ Uᵀ, two for every point whose rows U = B were added, in that order.
class UpdateColumns {
 public:
  virtual ~UpdateColumns() = default;
  /// Adds two columns for each point, and what they have in common with all that were there to G = U Z,
  /// which is large enough for it.
  virtual void add(std::span<const std::size_t> points, Eigen::MatrixXd& g) = 0;
  /// No points are added from here on; what is known of their columns may be kept.
  virtual void begin_anew() = 0;
  /// Keeps the points at these places, which are numbered so now, and corrects Z and G for the border that K has:
  /// of that before it so many nodes are still there. False where they have to be made anew.
  virtual bool follow(std::span<const std::size_t> kept, std::span<const std::size_t> points,
                      std::size_t nodes, Eigen::MatrixXd& g) = 0;
  /// x −= Z s for each x, s in the columns of `shares`, which has 2 rows for each of the places.
  virtual void subtract(std::span<const std::size_t> places, const Eigen::MatrixXd& shares,
                        std::span<const std::span<double>> solutions) = 0;
  /// Zᵀ ∂g/∂d of a gauge, 2 for every point that was added.
  virtual Eigen::VectorXd along(const Functional& gauge) = 0;
  /// Whether a product with Z costs less than a solution with K.
  virtual bool product_is_cheap() const = 0;
  /// Columns that are worth making at once; for more, a new K is cheaper.
  virtual std::size_t most_at_once() const = 0;
  /// Solutions with K that were computed, half ones of products counted as one.
  std::size_t num_solves() const { return num_solves_; }

 protected:
  std::size_t num_solves_ = 0;
};

/// Columns for what the solver has factorised last and its border; points between two multiples of `batch` are
/// always added together, in order.
std::unique_ptr<UpdateColumns> update_columns(const Equilibrium& equilibrium, BorderedSolver& solver,
                                              std::size_t batch);

/// The same where the solver has half solutions.
std::unique_ptr<UpdateColumns> half_columns(const Equilibrium& equilibrium, const BorderedSolver& solver,
                                            std::size_t batch);

}  // namespace dda
