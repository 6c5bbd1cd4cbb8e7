#include "studies/dda/record/warnings/bearings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dda {
namespace {

/// Width of the proposed patch in sizes of the blocks at the point.
constexpr double patch_width = 6;

std::string place_text(const Vec2& x) { return fmt::format("({:.6g}, {:.6g})", x.x(), x.y()); }

/// The longest straight line of outer sides through a point, by its tangent and how far it reaches to both
/// ends [L].
struct Straight {
  Vec2 tangent = Vec2::Zero();
  double back = 0, ahead = 0;
};

std::optional<Straight> boundary_at(const Assembly& assembly, const Vec2& at) {
  std::optional<Straight> best;
  for (const BoundarySide& first : assembly.boundary) {
    const double length = (first.end - first.start).norm(), tol = 1e-6 * length;
    if (distance(at, first.start, first.end) > tol) continue;
    const Vec2 t = (first.end - first.start) / length;
    Straight line{t, t.dot(first.start - at), t.dot(first.end - at)};
    for (bool grown = true; grown;) {
      grown = false;
      for (const BoundarySide& side : assembly.boundary) {
        const double start = t.dot(side.start - at), end = t.dot(side.end - at);
        const bool is_on =
            std::abs(cross(t, side.start - at)) <= tol && std::abs(cross(t, side.end - at)) <= tol;
        if (!is_on || end < line.back - tol || start > line.ahead + tol) continue;
        if (start >= line.back && end <= line.ahead) continue;
        line.back = std::min(line.back, start);
        line.ahead = std::max(line.ahead, end);
        grown = true;
      }
    }
    if (!best || line.ahead - line.back > best->ahead - best->back) best = line;
  }
  return best;
}

/// A round number of at most two digits.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

void add_loads(const Simulation& simulation, std::vector<Bearing>& out) {
  const Assembly& assembly = simulation.assembly();
  for (const StageParameters& stage : simulation.deck().stages)
    for (const LoadChoice& load : stage.loads) {
      const auto action = load.make()->action();
      if (!action || !action->place.at) continue;
      const Vec2 at = locate(assembly, *action->place.at);
      out.push_back({fmt::format("{} at {}", load.name(), place_text(at)), at, load.where(),
                     blocks_of(assembly, action->place, load.where())});
    }
}

/// What the joints around some blocks hold together by their strength [F]; nothing where one cannot crack.
std::optional<double> holding_force(const Equilibrium& equilibrium, const std::vector<BlockId>& blocks) {
  double sum = 0;
  for (const InterfacePoint& point : equilibrium.interfaces().points) {
    if (is_member(blocks, point.first) == is_member(blocks, point.second)) continue;
    if (!point.law->can_crack()) return {};
    const double strength = point.stiffness * point.law->initial_kappa(point.stiffness);
    if (std::isfinite(strength)) sum += point.weight * strength;
  }
  return sum;
}

std::string tearing_warning(const Simulation& simulation, const Bearing& bearing, double force) {
  const Assembly& assembly = simulation.assembly();
  const bool is_one = bearing.blocks.size() == 1;
  return fmt::format(
      "{}: {} acts on {} of size {:.3g} that only joints which can crack hold, {:.3g} {} strong together: "
      "under "
      "loads of that order {} torn out, and the peak is not the structure's; {}",
      to_string(bearing.where), bearing.name,
      is_one ? "one block" : fmt::format("{} blocks", bearing.blocks.size()), size_of(assembly, bearing),
      force, simulation.deck().units.force, is_one ? "it may be" : "they may be",
      patch_proposal(assembly, bearing));
}

}  // namespace

double area_of(const Assembly& assembly, const std::vector<BlockId>& blocks) {
  return std::accumulate(blocks.begin(), blocks.end(), 0.0, [&](double sum, BlockId id) {
    return sum + assembly.blocks[id.value()].moments.area;
  });
}

bool is_member(const std::vector<BlockId>& blocks, BlockId id) {
  return std::ranges::find(blocks, id) != blocks.end();
}

double area_around(const Assembly& assembly, BlockId id) {
  for (const auto& group : connected_groups(assembly))
    if (is_member(group, id)) return area_of(assembly, group);
  return 0;
}

double size_of(const Assembly& assembly, const Bearing& bearing) {
  return std::sqrt(area_of(assembly, bearing.blocks) / static_cast<double>(bearing.blocks.size()));
}

std::string patch_proposal(const Assembly& assembly, const Bearing& bearing) {
  const auto line = boundary_at(assembly, bearing.at);
  if (!line) return "give a place on the boundary as `over: [from, to]`, or bond the joints around it";
  const double size = size_of(assembly, bearing);
  const double wanted = rounded(patch_width * size), around = 2 * std::min(-line->back, line->ahead);
  // About the point where there is room for some blocks, else beside it.
  const double room = around < patch_width / 2 * size ? line->ahead - line->back : around;
  const double width = std::min(wanted, room);
  const double from = std::clamp(-width / 2, line->back, line->ahead - width);
  const auto corner = [&](double s) {
    const Vec2 x = bearing.at + s * line->tangent;
    return fmt::format("[{:.7g}, {:.7g}]", x.x(), x.y());
  };
  return fmt::format("spread it over several blocks: `over: [{}, {}]` instead of `at`", corner(from),
                     corner(from + width));
}

std::vector<Bearing> bearings_of(const Simulation& simulation) {
  const Assembly& assembly = simulation.assembly();
  std::vector<Bearing> out;
  for (const auto& [name, support] : simulation.deck().supports) {
    if (!support.at) continue;
    const Vec2 at = locate(assembly, *support.at);
    out.push_back({fmt::format("support '{}' at {}", name, place_text(at)), at, support.where,
                   blocks_of(assembly, support, support.where)});
  }
  add_loads(simulation, out);
  return out;
}

std::vector<std::string> tearing_warnings(const Simulation& simulation) {
  const Assembly& assembly = simulation.assembly();
  std::vector<std::string> out;
  for (const Bearing& bearing : bearings_of(simulation)) {
    const double whole = area_around(assembly, bearing.blocks.front());
    if (area_of(assembly, bearing.blocks) > small_share * whole) continue;
    if (const auto force = holding_force(simulation.equilibrium(), bearing.blocks))
      out.push_back(tearing_warning(simulation, bearing, *force));
  }
  return out;
}

}  // namespace dda
