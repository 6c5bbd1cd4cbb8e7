#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "continuation/linear/cholesky/cholmod_matrix.hpp"
#include "continuation/ranks/ranks.hpp"

namespace dda {

/// What a rank is asked for, about one of its parts. What follows it in a message stands beside; a matrix goes
/// column by column, with the number of its entries.
enum class Order : int {
  count,     ///< matrix → bytes of the factor, operations
  factor,    ///< threads, matrix → whether it is definite, L_B L_Bᵀ − A_B, operations
  begin,     ///< columns, b_I → rest
  complete,  ///< x_B → x_I, for the columns that were begun
  add,       ///< groups, whether their products with all are wanted → rest of each, products
  product,   ///< two groups → product
  multiple,  ///< group, column, numbers → y times these
  finish,    ///< sums, x_B → x_I of each sum
  subtract,  ///< sums, x_B → x_I of each sum
  along,     ///< entries → rest, products
  forget,    ///< keep no columns
  drop,      ///< no more of this part
  memory,    ///< largest memory that the process has held [bytes]
};

/// A strip of the structure with its border (strips.hpp): what one rank does of a factorisation,
///
///     A_I = L_I L_Iᵀ,     S_B = −A_BI A_I⁻¹ A_IB,
///
/// of solutions, and of the columns of cracked points, of which it keeps the rows that are its own.
class StripPart {
 public:
  /// Reads what the order wants and writes the reply.
  void answer(Order order, Message& request, Message& reply);

 private:
  struct Group {
    std::size_t name;
    HalfSolution y;
  };

  void factor(Message& request, Message& reply);
  void count(Message& request, Message& reply);
  void begin(Message& request, Message& reply);
  void complete(Message& request, Message& reply);
  void add(Message& request, Message& reply);
  void product(Message& request, Message& reply);
  void multiple(Message& request, Message& reply);
  void subtract(Message& request, Message& reply);
  void along(Message& request, Message& reply);
  const HalfSolution& half_of(std::size_t name) const { return groups_[place_[name]].y; }
  std::size_t num_inner_rows() const { return num_rows_ - matrix_.num_border_rows(); }
  /// Columns of a strip with zeros in its border.
  std::vector<double> with_border(std::span<const double> inner) const;
  void finish(Message& request, Message& reply);
  /// x_I from y and the solution in the border, in each column of `sums`.
  void finish(std::span<double> sums, const std::vector<double>& border, Message& reply);

  CholmodMatrix matrix_;
  std::size_t num_rows_ = 0;  ///< unknowns of the strip and its border
  std::vector<Group> groups_;
  std::vector<std::size_t> place_;  ///< by the name of a group, `none` where it has nothing here
  std::vector<double> begun_;       ///< y of the columns that were begun
};

/// What a rank answers: of its parts, by the numbers of the matrices that they belong to.
Answer answer_by_parts();

/// The largest memory that each rank has held so far [bytes].
std::vector<double> memory_by_rank(Ranks& ranks);

/// The rows of some blocks as a matrix of its own, its last blocks a border; what `factor` and `count` read.
void put_matrix(const BlockMatrix& a, std::span<const std::size_t> blocks, std::size_t border, Message& to);

void put_entries(std::span<const HalfSolver::Entry> entries, Message& to);

}  // namespace dda
