// How long the next step of a path is.
#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/path/path.hpp"

namespace dda {
namespace {

/// What changes of the load are measured by: its largest so far, and where dead loads have cracked the
/// structure before there is any, a hundredth of the forces that act.
double load_size(const PathMemory& memory, const PathParameters& parameters) {
  constexpr double hardly = 0.01;
  const bool is_force = parameters.load_gauge.empty();
  return std::max(memory.peak_load, is_force ? hardly * memory.largest_force : 0.0);
}

}  // namespace

/// The first step after a crack: small against the load and against what the fastest point may still open;
/// where dead loads have cracked and there is no load yet, against the way to the next crack.
double Path::first_amount() const {
  const Tangent& leaving = walker_.leaving();
  if (!leaving.dissipates)
    return 0.25 * std::min(next_event(walker_), std::max(1e-3, std::abs(walker_.state().load_factor)));
  constexpr double of_load = 0.02, of_opening = 0.1, of_way = 0.25;
  const double load_rate = std::abs(leaving.rate(load_)), load = std::abs(load_of(walker_.state()));
  double amount = load > 0 && load_rate > 0 ? of_load * load / load_rate
                  : load == 0               ? of_way * next_new_crack(walker_)
                                            : std::numeric_limits<double>::infinity();
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

/// How far a first step goes where contacts alone change, the nearest change being no measure: it may lie
/// next to nothing ahead.
double Path::sliding_amount() const {
  constexpr double little = 0.001;
  const double load_rate = std::abs(walker_.leaving().rate(load_));
  return load_rate > 0 ? little * load_size(memory_, parameters_) / load_rate : 0;
}

/// No step may be predicted to change load or displacement by more than the deck allows.
double Path::bounded(double amount) const {
  const double load_rate = std::abs(walker_.leaving().rate(load_));
  const double displacement_rate_now = std::abs(displacement_rate(walker_.leaving()));
  const double load_size_now = load_size(memory_, parameters_);
  const bool only_slides = !walker_.leaving().dissipates && can_slide();
  const double of_load =
      only_slides ? 1.5 : 1;  // steps of contacts alone are exact but for the order of changes
  if (load_rate > 0 && load_size_now > 0)
    amount = std::min(amount, of_load * parameters_.step.largest * load_size_now / load_rate);
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
                      std::max(load_size(memory_, parameters_), std::abs(load_of(candidate.state)));
  const double displacement =
      std::abs(displacement_of(predicted) - displacement_of(candidate.state)) /
      std::max(memory_.largest_displacement, std::abs(displacement_of(candidate.state)));
  constexpr double balance_share = 0.005;  // of the accuracy, for the energy a step leaves unaccounted for
  const double strayed = std::max(
      {load, displacement, std::abs(missing_work(candidate)) / candidate.work / balance_share, 1e-12});
  memory_.step =
      amount * unit_of(move) * std::clamp(std::sqrt(parameters_.step.accuracy / strayed), 0.3, 2.0);
  memory_.step_control = move.control;
}

}  // namespace dda
