#include "continuation/state/least_memory.hpp"

#include <fmt/format.h>

#include "framework/base/memory.hpp"

namespace dda {

LeastMemory least_memory(const Equilibrium& equilibrium, DirectSolver& solver) {
  // Here, at the candidate and on the way there: d, its tangents, guesses, residuals and right-hand sides.
  constexpr double vectors = 16;
  // Histories of the system, of here and of the candidate; q, t and D twice; D of the base and of the tangent.
  constexpr double bytes_of_point = 3 * sizeof(History) + (2 * 8 + 2 * 4) * sizeof(double);
  return {.factor = solver.factor_bytes(equilibrium.intact()),
          .vectors = vectors * sizeof(double) * static_cast<double>(equilibrium.num_unknowns()) +
                     bytes_of_point * static_cast<double>(equilibrium.num_active())};
}

std::unique_ptr<DirectSolver> affordable_solver(const Equilibrium& equilibrium,
                                                const DirectSolverChoice& choice) {
  std::unique_ptr<DirectSolver> out = choice.make();
  const LeastMemory least = least_memory(equilibrium, *out);
  const double needed = least.factor + least.vectors;
  if (needed <= memory_limit()) return out;
  throw InputError(
      {}, fmt::format("{} blocks need at least {:.3g} GiB of memory for the factor and vectors, and "
                      "there are {:.3g}; make the blocks larger, or give `--memory-limit` to try "
                      "it all the same",
                      equilibrium.num_blocks(), needed / bytes_per_gib, memory_limit() / bytes_per_gib));
}

}  // namespace dda
