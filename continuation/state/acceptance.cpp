#include "continuation/state/acceptance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "continuation/state/standstill.hpp"

namespace dda {
namespace {

using Translation = Eigen::Map<const Vec2>;

/// Where a block is, from the points of its sides.
Vec2 place_of(const Equilibrium& equilibrium, std::size_t block) {
  Vec2 sum = Vec2::Zero();
  int count = 0;
  for (const InterfacePoint& point : equilibrium.interfaces().points) {
    if (point.first.value() != block && point.second.value() != block) continue;
    sum += point.x;
    ++count;
  }
  return count > 0 ? Vec2(sum / count) : sum;
}

std::string names_of(const std::vector<std::size_t>& blocks, const Equilibrium& equilibrium) {
  constexpr std::size_t most = 3;
  std::string out;
  for (std::size_t i = 0; i < std::min(blocks.size(), most); ++i) {
    const Vec2 at = place_of(equilibrium, blocks[i]);
    out += fmt::format("{}block {} at ({:.4g}, {:.4g})", i == 0 ? "" : ", ", blocks[i], at.x(), at.y());
  }
  return blocks.size() > most ? out + fmt::format(" and {} more", blocks.size() - most) : out;
}

}  // namespace

Excess strength_excess(const System& system, const std::vector<History>& history, const LawValues& laws) {
  Excess out;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const History& h = history[p];
    if (!point.law->releases_at_once() || point.law->is_broken(h, point.stiffness)) continue;
    const double opening = point.law->equivalent_opening(laws.opening[p], h, point.stiffness);
    const double beyond = opening / point.law->kappa(h, point.stiffness) - 1;
    if (beyond > out.value) out = {beyond, p};
  }
  return out;
}

Holding holding_of(const System& system, const State& at) {
  const Equilibrium& equilibrium = system.equilibrium();
  const std::vector<double>& d = at.d;
  Holding out{.load = load_on(system, at), .weak = system.weak_forces(d), .blocks = {}};
  const auto moved = [&](std::size_t b) { return Translation(d.data() + block_unknowns * b).norm(); };
  for (std::size_t b = 0; b < equilibrium.num_blocks(); ++b) out.movement = std::max(out.movement, moved(b));
  for (std::size_t b = 0; b < equilibrium.num_blocks(); ++b)
    if (moved(b) > 0 && moved(b) >= 0.5 * out.movement) out.blocks.push_back(b);
  return out;
}

Holding bound_of_holding(const System& system, const State& at) {
  constexpr double beyond = 10;
  const Equilibrium& equilibrium = system.equilibrium();
  Holding out{.load = load_on(system, at), .blocks = {}};
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p)
    out.movement = std::max(out.movement, beyond * system.jump(p, at.d).norm());
  out.movement = std::max(out.movement, beyond * system.movement_of_loads(at));
  out.weak = equilibrium.weak_stiffness() * static_cast<double>(equilibrium.num_blocks()) * out.movement;
  return out;
}

/// Where loads only stretch and bend single blocks, as tractions in balance on one do and initial stress, their forces and
/// couples are rounding, and what counts is the stress that they make.
double load_on(const System& system, const State& at) {
  constexpr double rounding = 1e-9;
  const System::LoadSizes of_blocks = system.load_sizes(at);
  const double loads = std::max(system.sum_of_forces(at), of_blocks.couples);
  return loads <= rounding * of_blocks.all ? system.force_level(at.d) : loads;
}

std::string objection_to(const Holding& holding, const SoundnessLimits& limits,
                         const Equilibrium& equilibrium) {
  constexpr double of_load = 1e-3, of_largest = 1e-3;
  if (!(holding.movement <= limits.size))
    return fmt::format(
        "{} would move by {:.3g}, the structure being {:.3g} large: only weak springs hold it, or the "
        "load is far beyond what small displacements describe",
        names_of(holding.blocks, equilibrium), holding.movement, limits.size);
  const double load = std::max(holding.load, of_largest * limits.largest_load);
  if (holding.weak <= of_load * load) return {};
  return fmt::format("only weak springs hold {}: they would bear {:.1e} of the load",
                     names_of(holding.blocks, equilibrium), holding.weak / load);
}

std::string objection_to(const Excess& excess, const System& system) {
  constexpr double bearable = 1e-4;
  if (excess.value <= bearable) return {};
  return fmt::format("the point at {} stands {:.1e} beyond its strength", places_of(system, {excess.point}),
                     excess.value);
}

}  // namespace dda
