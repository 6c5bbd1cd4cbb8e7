// How long the next step of a path is.
#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/path.hpp"

namespace dda {

/// The first step after a crack: small against the load and against what the fastest point may still open.
double Path::first_amount() const {
  const Tangent& leaving = walker_.leaving();
  if (!leaving.dissipates)
    return 0.25 * std::min(next_event(walker_), std::max(1e-3, std::abs(walker_.state().load_factor)));
  constexpr double of_load = 0.02, of_opening = 0.1;
  const double load_rate = std::abs(leaving.rate(load_)), load = std::abs(load_of(walker_.state()));
  // Of no load there is no share: dead loads alone have cracked something.
  double amount =
      load_rate > 0 && load > 0 ? of_load * load / load_rate : std::numeric_limits<double>::infinity();
  const System& system = walker_.system();
  const auto laws = system.laws(walker_.state().d, walker_.state().load_factor);
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const History& h = system.history()[p];
    if (!h.loading) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const double rate =
        point.law->opening_gradient(laws.opening[p], h, point.stiffness).dot(leaving.opening[p]);
    const double left = point.law->rupture_kappa(point.stiffness) - system.kappa(p);
    if (rate > 0 && left > 0) amount = std::min(amount, of_opening * left / rate);
  }
  return amount;
}

/// What a step is measured in, per unit of the leaving tangent: the control's own quantity. Where cracks grow
/// both are energies; elsewhere the tangent's unit, the load factor, may all but stand still.
double Path::unit_of(const Move& move) const {
  return walker_.leaving().dissipates ? 1 : std::abs(move.rate);
}

/// Amount after which the proportional loads by themselves would have stored what is stored here: what a step
/// is compared with where contacts alone change, which begin to under next to no load. 0 where that is not
/// elastic.
double Path::sliding_amount() const {
  const Tangent& leaving = walker_.leaving();
  const double power = leaving.load_factor * displacement_rate(leaving);
  return !leaving.dissipates && can_slide() && power > 0 ? std::sqrt(2 * walker_.here().stored / power) : 0;
}

/// No step may be predicted to change load or displacement by more than the deck allows.
double Path::bounded(double amount) const {
  const double load_rate = std::abs(walker_.leaving().rate(load_));
  const double displacement_rate_now = std::abs(displacement_rate(walker_.leaving()));
  const double load_scale = std::max(memory_.peak_load, load_rate * sliding_amount());
  if (load_rate > 0 && load_scale > 0)
    amount = std::min(amount, parameters_.step.largest * load_scale / load_rate);
  constexpr double of_displacement = 5;  // displacement may grow by half in one step of the default size
  if (displacement_rate_now > 0 && memory_.largest_displacement > 0)
    amount = std::min(amount, of_displacement * parameters_.step.largest * memory_.largest_displacement /
                                  displacement_rate_now);
  return amount;
}

/// The next step from how far this one strayed from its tangent.
void Path::resize(const Candidate& candidate, double amount, const Move& move) {
  const State predicted = walker_.ahead(amount);
  const double load = std::abs(load_of(predicted) - load_of(candidate.state)) /
                      std::max(memory_.peak_load, std::abs(load_of(candidate.state)));
  const double displacement =
      std::abs(displacement_of(predicted) - displacement_of(candidate.state)) /
      std::max(memory_.largest_displacement, std::abs(displacement_of(candidate.state)));
  constexpr double balance_share = 0.005;  // of the accuracy, for the energy a step leaves unaccounted for
  const double strayed =
      std::max({load, displacement, unaccounted(candidate) / candidate.work / balance_share, 1e-12});
  memory_.step =
      amount * unit_of(move) * std::clamp(std::sqrt(parameters_.step.accuracy / strayed), 0.3, 2.0);
  memory_.step_control = move.control;
}

}  // namespace dda
