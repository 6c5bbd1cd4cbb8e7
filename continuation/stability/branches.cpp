#include "continuation/stability/branches.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "continuation/stability/stiffness_modes.hpp"
#include "continuation/state/history_guard.hpp"

namespace dda {
namespace {

/// The points on their damage surface at an equilibrium, and how fast a direction opens them.
class Surface {
 public:
  Surface(System& system, const Candidate& here) : system_(system), here_(here) {
    const auto laws = system.laws_at(here.state);
    for (std::size_t p = 0; p < here.history.size(); ++p) {
      const History& h = here.history[p];
      const InterfacePoint& point = system.equilibrium().point(p);
      if (!h.loading || point.law->releases_at_once()) continue;
      points_.push_back(p);
      gradients_.push_back(point.law->opening_gradient(laws->opening[p], h, point.stiffness));
      spending_.push_back(point.weight * point.law->spending(laws->opening[p], h, point.stiffness).gradient);
    }
  }

  /// Rate of the equivalent opening of each of them along a direction in which blocks move.
  std::vector<double> rates(std::span<const double> d) const {
    std::vector<double> out;
    for (std::size_t i = 0; i < points_.size(); ++i)
      out.push_back(gradients_[i].dot(system_.opening_rate(points_[i], d)));
    return out;
  }
  std::vector<double> rates(const Tangent& along) const {
    std::vector<double> out;
    for (std::size_t i = 0; i < points_.size(); ++i)
      out.push_back(gradients_[i].dot(along.opening[points_[i]]));
    return out;
  }
  /// c·d, the rate of dissipation if all of them load.
  double dissipation(std::span<const double> d) const {
    double sum = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
      sum += spending_[i].dot(system_.opening_rate(points_[i], d));
    return sum;
  }
  /// The flags with only those points loading whose number is set.
  std::vector<History> flags(const std::vector<bool>& loads) const {
    std::vector<History> out = here_.history;
    for (std::size_t i = 0; i < points_.size(); ++i) out[points_[i]].loading = loads[i];
    return out;
  }
  /// Which of them load by these flags.
  std::vector<bool> loading(const std::vector<History>& flags) const {
    std::vector<bool> out;
    for (const std::size_t p : points_) out.push_back(flags[p].loading);
    return out;
  }

 private:
  System& system_;
  const Candidate& here_;
  std::vector<std::size_t> points_;
  std::vector<Vec2> gradients_, spending_;
};

double largest(const std::vector<double>& values) {
  double out = 0;
  for (const double value : values) out = std::max(out, std::abs(value));
  return out;
}

constexpr double round_off = 1e-9;

/// The branch on which exactly those points load that its direction opens, from a first guess of them.
std::optional<Branch> settle(System& system, const Candidate& here, const Surface& surface,
                             std::vector<bool> loads) {
  constexpr int most_changes = 20;
  for (int change = 0; change < most_changes; ++change) {
    system.set_history(surface.flags(loads));
    Tangent found = leaving_tangent(system, here.state, arriving_tangent(system, here.state));
    if (found.d.empty() || !found.dissipates) return {};
    const std::vector<double> rates = surface.rates(found);
    std::vector<bool> next = surface.loading(system.history());
    const double unit = round_off * largest(rates);
    bool agrees = true;
    for (std::size_t i = 0; i < rates.size(); ++i)
      if (!next[i] && rates[i] > unit) next[i] = !(agrees = false);
    if (agrees)
      return Branch{std::move(found), system.history(),
                    system.path_linear().negative_eigenvalues().of_stiffness};
    loads = std::move(next);
  }
  return {};
}

/// The negative eigenvectors; none where they do not converge.
std::vector<std::vector<double>> critical_modes(System& system, const Candidate& here,
                                                const DirectSolverChoice& solver) {
  const Equilibrium& equilibrium = system.equilibrium();
  ModeRequest wanted{
      .count = *here.num_negative, .mass = Mass::identity(equilibrium.num_nodes()), .is_physical = false};
  for (std::size_t node = 0; node < equilibrium.num_block_nodes(); ++node) {
    const double size = *equilibrium.strain_size(node);
    const int num_strains = node < equilibrium.num_blocks() ? 4 : block_unknowns;  // and the rotation
    wanted.mass.diagonal[node].diagonal().tail(num_strains) *= size * size;
  }
  try {
    const auto found = stiffness_modes(system, here.state, solver, wanted);
    return found ? found->modes.shapes : std::vector<std::vector<double>>{};
  } catch (const std::runtime_error&) {
    return {};
  }
}

/// ψ = φ − (c·φ) ḋ in rates of the points on their surface; empty where nothing is left of φ.
std::vector<double> freed(const Surface& surface, const std::vector<double>& mode, const Tangent& path) {
  constexpr double nothing = 1e-6;
  std::vector<double> out = surface.rates(mode);
  const double whole = largest(out), share = surface.dissipation(mode);
  const std::vector<double> along = surface.rates(path);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] -= share * along[i];
  if (largest(out) <= nothing * whole) return {};
  return out;
}

}  // namespace

std::vector<Branch> branches_at(System& system, const Candidate& here, const DirectSolverChoice& solver) {
  const HistoryGuard back(system);
  system.set_history(here.history);
  const Surface surface(system, here);
  std::vector<std::vector<bool>> known{surface.loading(here.history)};
  std::vector<Branch> out;
  for (const auto& mode : critical_modes(system, here, solver)) {
    const std::vector<double> rates = freed(surface, mode, here.arriving);
    for (const double sign : {1.0, -1.0}) {
      if (rates.empty()) continue;
      std::vector<bool> loads;
      for (const double rate : rates) loads.push_back(sign * rate > round_off * largest(rates));
      const auto branch = settle(system, here, surface, std::move(loads));
      if (!branch) continue;
      std::vector<bool> set = surface.loading(branch->flags);
      if (std::ranges::find(known, set) != known.end()) continue;
      known.push_back(std::move(set));
      out.push_back(*branch);
    }
  }
  return out;
}

}  // namespace dda
