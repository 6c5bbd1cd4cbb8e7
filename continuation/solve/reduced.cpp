#include "continuation/solve/reduced.hpp"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

bool has_offsets(const System& system) {
  return !system.loading().dead_offset.empty() || !system.loading().reference_offset.empty();
}

/// A tie of exact multipliers holds 1/δ times as firmly as its own stiffness P, and where a body has more
/// ties than motions the openings would answer a traction with that factor's rounding. With a share of P
/// instead the multiplier follows from the gap, m = s/(1 + δ − s) g, so that the joint of the base is a
/// spring.
constexpr double loosened = 0.9;

/// Along joints of bodies that only touch the stiff spring of an iterated multiplier makes a long slide out
/// of a tiny load: the load factor would be told from the rounding of q. A softer one leaves less of that.
constexpr double softened = 0.1;

/// Points without columns that are not as in the base.
std::vector<std::size_t> newly_cracked(System& system, const LinearSystem& linear, const State& at) {
  const auto laws = system.laws_at(at.d, at.load_factor);
  std::vector<std::size_t> out;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    if (linear.has_columns(p)) continue;
    const Vec2 jump =
        system.iterates_multipliers() ? Vec2(laws->opening[p] - system.multipliers()[p]) : laws->opening[p];
    if (!linear.is_as_in_base(p, jump, {laws->traction[p], laws->tangent[p]})) out.push_back(p);
  }
  return out;
}

/// By Newton's method where something cracks, that is wanted and does it, else by walking: where only
/// contacts change one walk is all, and Newton's method steps round between their pieces.
std::optional<int> iterate(CrackedPoints& points, const State& guess, const ContactSettings& settings) {
  points.start_at(guess);
  if (settings.tries_newton && !points.only_touch())
    if (const auto iterations = points.newton(settings.max_iterations, CrackedPoints::Cycles::end_it))
      return iterations;
  points.start_at(settings.from ? *settings.from : guess);
  return points.walk(settings.max_iterations);
}

/// What rounding leaves of the equations of the whole structure is taken off as far as it can be, and where
/// bodies only touch what the weak springs bear.
void refine(System& system, CrackedPoints& points, Reduced& found, const ContactSettings& settings) {
  constexpr int most = 3;
  double excess = system.excess_residual(found.state);
  const bool once = points.only_touch();
  for (int i = 0; i < most && (excess > settings.tolerance || (once && i == 0)); ++i) {
    using enum CrackedPoints::Accuracy;
    points.refine();
    const auto accuracy = once && excess > settings.tolerance ? of_what_is_carried : of_openings;
    if (!points.walk(settings.max_iterations, 1, accuracy)) return;
    State next = points.state();
    next.multipliers = found.state.multipliers;
    const double left = system.excess_residual(next);
    if (left > std::max(excess, settings.tolerance)) return;
    excess = left;
    found.state = std::move(next);
  }
}

/// Solves contacts under a control that is a sum, taking points in until none is left out.
std::optional<Reduced> solve_sum(System& system, const ControlSum& sum, const State& guess,
                                 const ContactSettings& settings, std::optional<CrackedPoints>& points) {
  LinearSystem& linear = system.contact_linear();
  Reduced out{.state = guess};
  constexpr int most_rounds = 60;
  for (int round = 0; round < most_rounds; ++round) {
    if (linear.updated_points().size() > settings.most_points) return {};
    if (!points || points->num_points() != linear.updated_points().size())
      points.emplace(system, linear, sum);
    const auto scope = system.timings().measure("contact");
    const auto iterations = iterate(*points, guess, settings);
    if (!iterations) return {};
    out.iterations += *iterations;
    out.state = points->state();
    out.state.multipliers = guess.multipliers;
    const std::vector<std::size_t> added = newly_cracked(system, linear, out.state);
    if (added.empty()) {
      refine(system, *points, out, settings);
      return out;
    }
    linear.add_points(added);
  }
  return {};
}

/// Under a control that looks at every point: its tangent is a gauge, taken anew at each state found.
std::optional<Reduced> solve_tangents(System& system, const ControlEquation& control, double s,
                                      const State& guess, const ContactSettings& settings) {
  Reduced out{.state = guess};
  constexpr int most = 20;
  for (int i = 0; i < most; ++i) {
    const auto laws = system.laws_at(out.state.d, out.state.load_factor);
    const ControlPoint at{out.state.d, out.state.load_factor, *laws};
    constexpr double good = 1e-10;
    if (i > 0 && std::abs(control.residual(at, s)) <= good) return out;
    const auto tangent = control.tangent_gauge(at, s);
    if (!tangent) return {};
    const ControlSum sum{.gauge = &tangent->gauge, .spends = false, .target = tangent->value, .scale = 1};
    std::optional<CrackedPoints> points;
    const auto found = solve_sum(system, sum, out.state, settings, points);
    if (!found) return {};
    out.state = found->state;
    out.iterations += found->iterations;
  }
  return {};
}

}  // namespace

std::optional<Reduced> solve_reduced(System& system, const ControlEquation& control, double s,
                                     const State& guess, int max_iterations) {
  const auto sum = control.as_sum(s);
  if (!sum || system.frozen() || !system.linear().updates() || system.iterates_multipliers()) return {};
  if (has_offsets(system)) return {};
  Reduced out;
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    CrackedPoints points(system, system.linear(), *sum);
    const auto iterations = [&] {
      const auto scope = system.timings().measure("reduced iterations");
      points.start_at(guess);
      return points.newton(max_iterations, CrackedPoints::Cycles::may_settle);
    }();
    if (!iterations) return {};
    out.iterations += *iterations;
    out.state = points.state();
    const std::vector<std::size_t> added = newly_cracked(system, system.linear(), out.state);
    if (added.empty()) return out;
    if (!system.linear().make_columns(added)) return {};
  }
  return {};
}

namespace {

/// Points of some kind that are not held at a state as in the intact structure.
template <class Kind>
std::size_t count_changed(System& system, const State& at, Kind is_of_kind) {
  const auto laws = system.laws_at(at.d, at.load_factor);
  std::size_t out = 0;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const Vec2 intact = point.intact_stiffness().cwiseProduct(laws->opening[p]);
    constexpr double round_off = 1e-14;
    out += (laws->traction[p] - intact).norm() > round_off * intact.norm() && is_of_kind(point);
  }
  return out;
}

}  // namespace

std::size_t num_changed(System& system, const State& at) {
  return count_changed(system, at, [](const InterfacePoint&) { return true; });
}

std::size_t num_cracked(System& system, const State& at) {
  return count_changed(system, at, [](const InterfacePoint& point) { return !point.is_separate(); });
}

void prepare_contacts(System& system, const State& guess) {
  constexpr std::size_t few = 100;
  const bool is_cracked = num_changed(system, guess) > few;
  const auto laws = system.laws_at(guess.d, guess.load_factor);
  std::vector<Mat2> base;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const History& h = system.history()[p];
    Mat2 tangent = point.intact_stiffness().asDiagonal();
    if (is_cracked && point.law->contact(h, point.stiffness) && !point.is_separate())
      tangent = point.law->respond_frozen(laws->opening[p], h, point.stiffness).tangent;
    if (point.is_separate() && point.multiplier == Multiplier::unknown) tangent *= loosened;
    if (point.is_separate() && point.multiplier == Multiplier::iterated) tangent(1, 1) *= softened;
    base.emplace_back(0.5 * (tangent + tangent.transpose()));
  }
  LinearSystem& linear = system.contact_linear();
  if (!linear.start_from(base)) {
    for (std::size_t p = 0; p < base.size(); ++p)
      base[p] = system.equilibrium().point(p).intact_stiffness().asDiagonal();
    linear.start_from(base);
  }
  linear.add_points(newly_cracked(system, linear, guess));
}

std::optional<Reduced> solve_contacts(System& system, const ControlEquation& control, double s,
                                      const State& guess, const ContactSettings& settings,
                                      std::optional<CrackedPoints>& points) {
  if (has_offsets(system) || !system.has_contacts()) return {};
  if (const auto sum = control.as_sum(s)) return solve_sum(system, *sum, guess, settings, points);
  return solve_tangents(system, control, s, guess, settings);
}

}  // namespace dda
