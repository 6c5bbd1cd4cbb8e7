// What a converged step may have passed over: the limit point, a wanted gauge value, the last rupture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/path/path.hpp"
#include "continuation/state/reach.hpp"

namespace dda {
namespace {

State between(const State& a, const State& b, double share) {
  State out = a;
  for (std::size_t i = 0; i < out.d.size(); ++i) out.d[i] += share * (b.d[i] - a.d[i]);
  out.load_factor += share * (b.load_factor - a.load_factor);
  for (std::size_t p = 0; p < out.multipliers.size(); ++p)
    out.multipliers[p] += share * (b.multipliers[p] - a.multipliers[p]);
  return out;
}

/// Whether what was to crack unloads instead: of what is spent along the tangent, more than half by points
/// that at the candidate neither load nor have broken.
bool unloads(const Walker& walker, const Candidate& candidate) {
  const System& system = walker.system();
  const LawValues laws = system.laws(walker.state().d, walker.state().load_factor);
  double all = 0, unloaded = 0;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const History &before = system.history()[p], &after = candidate.history[p];
    if (!before.loading) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const Spending spending = point.law->spending(laws.opening[p], before, point.stiffness);
    const double rate = point.weight * spending.gradient.dot(walker.leaving().opening[p]);
    all += rate;
    if (!after.loading && !point.law->is_broken(after, point.stiffness)) unloaded += rate;
  }
  return unloaded > 0.5 * all;
}

}  // namespace

/// Share of the step at which the limit point is to be sought, when the step crosses it and the peak is not
/// yet bracketed: where the tangents of both ends meet, an upper bound of a concave load and exact at a kink.
std::optional<double> Path::before_peak(const Candidate& candidate) const {
  const double dissipated = candidate.dissipated - walker_.here().dissipated;
  if (dissipated <= 0 || !walker_.leaving().dissipates || !candidate.arriving.dissipates) return {};
  const double sign = memory_.direction < 0 ? -1 : 1;
  const double rise = sign * walker_.leaving().rate(load_) * dissipated;
  const double fall = sign * candidate.arriving.rate(load_) * dissipated;
  if (rise <= 0 || fall >= 0) return {};
  const double from = load_of(walker_.state()), to = load_of(candidate.state);
  const double share = (to - from - fall) / (rise - fall);
  const double top = from + share * rise, highest = std::max({from, to, memory_.peak_load});
  if (top <= highest * (1 + parameters_.peak_tolerance)) return {};
  return std::clamp(share, 0.1, 0.9);
}

std::vector<Landing> Path::present_landings() const {
  std::vector<Landing> out = landings_;
  out.insert(out.end(), leg().until.begin(), leg().until.end());
  if (is_last_leg() && !leg().unloads && parameters_.stop.load_below > 0 && memory_.peak_load > 0)
    out.push_back({"load", load_,
                   (memory_.direction < 0 ? -1 : 1) * parameters_.stop.load_below * memory_.peak_load, true,
                   true});
  return out;
}

std::optional<Path::Crossing> Path::first_crossing(const Candidate& candidate) const {
  std::optional<Crossing> first;
  for (const Landing& landing : present_landings()) {
    const double from = walker_.value(landing.gauge);
    const double to = landing.gauge.value(candidate.state.d, candidate.state.load_factor);
    if (std::abs(from - landing.value) <= same_value * std::max(std::abs(landing.value), std::abs(to - from)))
      continue;
    if ((from - landing.value) * (to - landing.value) > 0) continue;
    if (landing.only_falling && std::abs(to) > std::abs(from)) continue;
    const double share = (landing.value - from) / (to - from);
    if (!first || share < first->share) first = Crossing{landing, share};
  }
  return first;
}

std::optional<Point> Path::land(const Candidate& beyond, const Crossing& crossing,
                                const std::string& control) {
  const Landing& landing = crossing.landing;
  const double step = landing.value - walker_.value(landing.gauge);
  const auto equation = make_gauge_equation(landing.gauge);
  const std::string place = fmt::format("{}={:g}", landing.name, landing.value);
  const std::string attempted = fmt::format("{}, landing on {}", control, place);
  std::string why;
  auto candidate =
      judged(walker_.attempt(*equation, step, between(walker_.state(), beyond.state, crossing.share)),
             attempted, why);
  if (!candidate) return {};
  constexpr double round_off = 1e-9;
  if (candidate->dissipated > beyond.dissipated * (1 + round_off)) {
    reject(attempted, "more energy is dissipated than beyond it");
    return {};
  }
  Point point = keep(*std::move(candidate), control);
  point.landed.push_back(place);
  return point;
}

/// Share of a step at which a point that loses its strength at once reaches it; 1 when none does.
double Path::share_to_strength(const Candidate& candidate) const {
  const System& system = walker_.system();
  const State &from = walker_.state(), &to = candidate.state;
  const auto before = system.laws(from.d, from.load_factor), after = system.laws(to.d, to.load_factor);
  constexpr double round_off = 1e-10;
  double share = 1;
  for (std::size_t p = 0; p < before.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (!point.law->releases_at_once()) continue;
    const LawAt law{*point.law, system.history()[p], point.stiffness};
    share = std::min(share, share_to_kappa(law, before.opening[p], after.opening[p], round_off));
  }
  return share;
}

/// Lands where the first of those points stands exactly at its strength.
std::optional<Point> Path::land_on_strength(const Candidate& beyond, const std::string& control) {
  const double share = share_to_strength(beyond);
  const auto equation = make_event_equation(walker_.system(), Initiation::at_once);
  std::string why;
  auto candidate = judged(walker_.attempt(*equation, 1, between(walker_.state(), beyond.state, share)),
                          control + ", landing on a strength", why);
  if (!candidate) return {};
  return keep(*std::move(candidate), control);
}

/// Lands on zero load: where the last crack of the structure breaks. Unloading ends there, too, and what
/// slides back dissipates.
std::optional<Point> Path::rupture() {
  const double load = load_.value(walker_.state().d, walker_.state().load_factor);
  const double rate = walker_.leaving().rate(load_);
  if (load * rate >= 0 || memory_.peak_load <= smallest_load()) return {};
  const std::string attempted = "load, landing on rupture";
  const auto equation = make_gauge_equation(load_);
  const double ahead = -load / rate;
  std::string why;
  auto candidate = judged(walker_.attempt(*equation, -load, walker_.ahead(ahead)), attempted, why);
  if (!candidate) return {};
  if (walker_.leaving().dissipates && unloads(walker_, *candidate)) {
    reject(attempted, "the load falls to nothing by unloading");
    return {};
  }
  if (const auto crossing = first_crossing(*candidate)) return land(*candidate, *crossing, "load");
  Point point = keep(*std::move(candidate), "load");
  point.landed.push_back("complete rupture");
  return point;
}

}  // namespace dda
