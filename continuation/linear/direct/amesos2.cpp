#include "continuation/linear/direct/direct_solver.hpp"
#include "framework/base/loaded.hpp"

namespace dda {
namespace {

struct Amesos2Parameters {};

Schema<Amesos2Parameters> schema() {
  return Schema<Amesos2Parameters>(
      "Sparse LU (KLU2 through Amesos2), a slower second opinion; one rank only.");
}

/// From its module: the start of a process with Amesos2's libraries takes 5 ms more.
std::unique_ptr<DirectSolver> make(const Amesos2Parameters&) {
  using Maker = DirectSolver* (*)();
  static const auto maker = reinterpret_cast<Maker>(symbol_of(module_file("dda_amesos2.so"), "dda_klu2"));
  return std::unique_ptr<DirectSolver>(maker());
}

}  // namespace

DDA_REGISTER(direct_solvers(), "amesos2", schema(), make);

}  // namespace dda
