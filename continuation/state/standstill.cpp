#include "continuation/state/standstill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda {

namespace {

double largest(const std::vector<double>& movements) {
  double out = 0;
  for (const double movement : movements) out = std::max(out, std::abs(movement));
  return out;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double out = 0;
  for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, std::abs(a[i] - b[i]));
  return out;
}

}  // namespace

bool Standstill::has_moved(const Watch& watch, const Station& now) const {
  if (watch.of_rescues && !now.is_rescue) return true;
  if (now.movements.size() != watch.from.movements.size()) return true;  // a crack through blocks has grown
  const double moved = distance(now.movements, watch.from.movements);
  if (moved > std::max(watch.share * largest_movement_, smallest_)) return true;
  if (largest_movement_ <= smallest_) return false;
  return std::abs(now.load_factor - watch.from.load_factor) > watch.share * largest_load_factor_ ||
         std::abs(now.dissipated - watch.from.dissipated) > watch.share * largest_dissipated_;
}

std::string Standstill::note_round(const Station& now) {
  constexpr double near = 1e-4;
  constexpr int most_returns = 5;
  Round& round = round_;
  const bool is_comparable = now.movements.size() == round.from.movements.size() && now.leg == round.from.leg;
  if (!is_comparable || ++round.steps > round.length) {
    round = {.from = now, .length = is_comparable ? 2 * round.length : 1};
    return {};
  }
  const bool is_back = distance(now.movements, round.from.movements) <= near * largest_movement_ &&
                       std::abs(now.load_factor - round.from.load_factor) <= near * largest_load_factor_;
  if (is_back && round.is_away) ++round.returns;
  round.is_away = !is_back;
  if (round.returns < most_returns) return {};
  return fmt::format("the path goes round, and has come back {} times in {} steps to where it stood before",
                     round.returns, round.steps);
}

void Standstill::forget() {
  round_ = {};
  for (Watch& watch : watches_) watch.has_begun = false;
}

std::string Standstill::add(const Station& now) {
  largest_movement_ = std::max(largest_movement_, largest(now.movements));
  largest_load_factor_ = std::max(largest_load_factor_, std::abs(now.load_factor));
  largest_dissipated_ = std::max(largest_dissipated_, std::abs(now.dissipated));
  std::string out = note_round(now);
  for (Watch& watch : watches_) {
    if (!watch.has_begun || has_moved(watch, now)) {
      watch.has_begun = true;
      watch.from = now;
      watch.count = 0;
    } else if (++watch.count >= watch.most && out.empty()) {
      out = fmt::format("in the last {} {} load, displacements and energies have changed by less than {:g}",
                        watch.count, watch.of_rescues ? "rescues" : "steps", watch.share);
    }
  }
  if (!out.empty()) forget();
  return out;
}

std::string places_of(const System& system, const std::vector<std::size_t>& points) {
  constexpr std::size_t most = 3;
  std::string out;
  for (std::size_t i = 0; i < std::min(points.size(), most); ++i) {
    const InterfacePoint& point = system.equilibrium().point(points[i]);
    const auto& names = system.equilibrium().interfaces().names;
    out += fmt::format("{}({:.6g}, {:.6g})", i == 0 ? "" : ", ", point.x.x(), point.x.y());
    if (point.interface >= 0)
      out += fmt::format(" on '{}'", names[static_cast<std::size_t>(point.interface)]);
  }
  if (points.size() > most) out += fmt::format(" and {} more", points.size() - most);
  return out;
}

std::vector<std::size_t> active_points(const System& system, const State& at) {
  std::vector<std::size_t> out;
  const LawValues laws = system.laws(at);
  std::size_t nearest = 0;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const History& h = system.history()[p];
    if (h.loading || h.sliding || h.share > 0) out.push_back(p);
    if (system.is_broken(p)) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const double ratio = point.law->equivalent_opening(laws.opening[p], h, point.stiffness) / system.kappa(p);
    if (ratio <= largest) continue;
    largest = ratio;
    nearest = p;
  }
  if (out.empty() && std::isfinite(largest)) out.push_back(nearest);
  return out;
}

}  // namespace dda
