#include "continuation/walk/power.hpp"

#include <cmath>

namespace dda {

double dissipation_rate(System& system, const State& state, const Tangent& along) {
  double sum = 0;
  bool grows = false;
  const auto laws = system.laws_at(state);
  for (std::size_t p = 0; p < along.opening.size(); ++p) {
    const History& h = system.history()[p];
    if (!h.loading && !h.sliding) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const double rate =
        point.weight *
        point.law->spending(laws->opening[p], h, point.stiffness).gradient.dot(along.opening[p]);
    grows = grows || (h.loading && rate != 0);
    sum += rate;
  }
  return grows ? sum : 0;
}

LivePower live_power(const System& system, const State& state, const Tangent& along) {
  const Loading& loading = system.loading();
  LivePower out;
  out.of_forces = along.rate(system.reference_work());
  out.size = std::abs(state.load_factor * out.of_forces);
  for (const WorkPair& pair : loading.driven)
    out.size += std::abs(state.value(pair.force) * along.rate(pair.displacement));
  return out;
}

}  // namespace dda
