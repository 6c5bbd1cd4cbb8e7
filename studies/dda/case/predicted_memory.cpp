#include "studies/dda/case/predicted_memory.hpp"

#include "continuation/linear/strips/shared_matrix.hpp"
#include "continuation/state/least_memory.hpp"
#include "framework/base/memory.hpp"

namespace dda {

PredictedMemory predicted_memory(const Simulation& simulation) {
  PredictedMemory out{.held = held_memory()};
  if (!simulation.deck().has_path()) return out;
  const auto solver = simulation.deck().path.linear.make();
  const LeastMemory least = least_memory(simulation.equilibrium(), *solver);
  out.factor = least.factor;
  out.vectors = least.vectors;
  return out;
}

std::vector<double> factors_by_rank(const Simulation& simulation, int ranks) {
  const BlockMatrix& stiffness = simulation.equilibrium().intact();
  std::vector<Answer> answers;
  for (int rank = 0; rank < ranks; ++rank) answers.push_back(answer_by_parts());
  if (stiffness.num_leading() == stiffness.num_rows()) {
    Ranks all = Ranks::here(std::move(answers));
    return SharedMatrix(all).bytes_by_rank(stiffness);
  }
  std::vector<double> out(answers.size(), 0.0);
  out.front() = simulation.deck().path.linear.make()->factor_bytes(stiffness);
  return out;
}

}  // namespace dda
