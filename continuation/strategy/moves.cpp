#include <algorithm>
#include <limits>

#include "continuation/reach.hpp"
#include "continuation/strategy/driver.hpp"

namespace dda {

double next_event(const Walker& walker) {
  const System& system = walker.system();
  const Equilibrium& equilibrium = system.equilibrium();
  const Tangent& leaving = walker.leaving();
  std::vector<double> now(2 * equilibrium.num_crackable()), rate(now.size());
  equilibrium.gather(system.loading(), walker.state().d, walker.state().load_factor, now);
  equilibrium.gather(leaving.d, rate);
  const auto& offset = system.loading().reference_offset;
  for (std::size_t i = 0; i < offset.size(); ++i) rate[i] += leaving.load_factor * offset[i];
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < equilibrium.num_crackable(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    const double kappa = system.kappa(p, system.history()[p]);
    if (kappa >= point.law->rupture_kappa(point.stiffness)) continue;
    nearest = std::min(nearest, reach(*point.law, Eigen::Map<const Vec2>(now.data() + 2 * p),
                                      Eigen::Map<const Vec2>(rate.data() + 2 * p), kappa));
  }
  return nearest;
}

Move event_move(const Walker& walker) {
  return {.control = "event",
          .equation = make_event_control(walker.system()),
          .arc = {},
          .rate = 1,
          .to_event = true};
}

Move dissipation_move(const Walker& walker) {
  return {
      .control = "dissipation", .equation = make_dissipation_control(walker.system()), .arc = {}, .rate = 1};
}

}  // namespace dda
