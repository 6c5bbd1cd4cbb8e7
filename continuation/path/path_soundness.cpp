// What is asked of an equilibrium before it is accepted, beside being one: that something holds it, that no
// point bears more than its strength, and that its energies balance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/path/path.hpp"
#include "continuation/state/acceptance.hpp"

namespace dda {

/// Work of the step less what it stored and dissipated [FL].
double Path::missing_work(const Candidate& candidate) const {
  const Candidate& here = walker_.here();
  return (candidate.work - here.work) - (candidate.stored - here.stored) -
         (candidate.dissipated - here.dissipated);
}

/// Why the sum of what the steps leave unaccounted for is too much with this one; "" when it is not.
std::string Path::energy_objection(const Candidate& candidate) const {
  const double missing = std::abs(memory_.imbalance + missing_work(candidate));
  const double energy =
      std::max({std::abs(candidate.work), std::abs(candidate.stored), std::abs(candidate.dissipated)});
  if (missing <= parameters_.stop.energy_error * energy) return {};
  unsound_ = fmt::format(
      "the energies do not balance: {:.1e} of the work is unaccounted for (at most "
      "`path.stop.energy_error`); try a smaller `path.step.accuracy`",
      missing / energy);
  return unsound_;
}

/// Why a converged state is no result; "" when it is one. Remembered for the end of the path.
std::string Path::unsoundness(const Candidate& candidate) const {
  const System& system = walker_.system();
  const Holding holding = holding_of(system, candidate.state);
  std::string why = objection_to(holding, {size_, memory_.largest_force}, system.equilibrium());
  if (why.empty()) why = objection_to(candidate.excess, system);
  if (!why.empty()) unsound_ = why;
  return why;
}

/// The end where every equilibrium that was found is unsound: of a path that is followed to rupture its goal,
/// when hardly any load is left.
std::optional<Point> Path::end_of_sound(std::string reason) {
  const std::string why = std::move(unsound_);
  unsound_.clear();
  constexpr double hardly_any = 0.01;
  const double left = std::abs(load_of(walker_.state())) / memory_.peak_load;
  if (parameters_.stop.load_below == 0 && walker_.here().dissipated > 0 && left < hardly_any)
    return end(Ending::Kind::goal_reached,
               fmt::format("complete rupture: {:.1e} of the peak was left; beyond, {}", left, why));
  return end(Ending::Kind::stopped_early, fmt::format("{} ({})", why, reason));
}

}  // namespace dda
