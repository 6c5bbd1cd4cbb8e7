#include "studies/memory_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "framework/output/provenance.hpp"

namespace dda {

MemoryPrediction predict_memory(const Simulation& simulation) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  constexpr double bytes_per_mib = 1024.0 * 1024.0, bytes_per_block = 36 * sizeof(double);
  constexpr double libraries = 8;      // MiB; HDF5 and Kokkos at work
  constexpr double loca_vectors = 88;  // that LOCA's stepper and groups hold during a step, counted
  const double n = static_cast<double>(equilibrium.num_unknowns());
  MemoryPrediction out;
  out.until_here = bytes_per_mib * (peak_memory_mib() + libraries);
  out.factor = simulation.deck().path.linear.make()->factor_bytes(equilibrium.intact());
  out.vectors = std::max(bytes_per_block * static_cast<double>(equilibrium.intact().num_stored()),
                         loca_vectors * sizeof(double) * n);
  // One crack through points that fill the plane, both of its sides and what is near it.
  const double points = static_cast<double>(equilibrium.num_active());
  const double cracked = std::min(points, 4 * std::sqrt(points));
  out.cracked_points = static_cast<std::size_t>(cracked);
  // A half solution is as long as the separators on its way, some 10 sqrt(n); couplings are kept with room to
  // grow.
  out.columns = sizeof(double) * (2 * cracked * 10 * std::sqrt(n) + 4 * std::pow(2 * cracked, 2));
  return out;
}

}  // namespace dda
