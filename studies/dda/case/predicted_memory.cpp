#include "studies/dda/case/predicted_memory.hpp"

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

}  // namespace dda
