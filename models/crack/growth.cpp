#include "models/crack/growth.hpp"

#include <algorithm>

namespace dda {
namespace {

using Found = std::optional<std::size_t>;

/// Where an active point stands.
struct Stand {
  std::optional<Cut> cut;
  Vec2 x;
};

std::vector<Stand> stands(const Equilibrium& equilibrium, const std::vector<Cut>& cuts) {
  std::vector<Stand> out;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    out.push_back({point.cut ? std::optional(cuts[*point.cut]) : std::nullopt, point.x});
  }
  return out;
}

std::vector<Cut> through_blocks(const std::vector<Cut>& cuts) {
  std::vector<Cut> out;
  std::ranges::copy_if(cuts, std::back_inserter(out), [](const Cut& cut) { return !cut.side; });
  return out;
}

std::vector<Found> nodes_of(std::size_t blocks, std::size_t multipliers, const std::vector<Cut>& before,
                            const std::vector<Cut>& now) {
  std::vector<Found> out;
  for (std::size_t b = 0; b < blocks; ++b) out.emplace_back(b);
  for (const Cut& cut : now) {
    const auto old = std::ranges::find_if(before, [&](const Cut& other) { return other.is_at(cut); });
    out.push_back(old == before.end() ? Found() : blocks + static_cast<std::size_t>(old - before.begin()));
  }
  for (std::size_t m = 0; m < multipliers; ++m) out.emplace_back(blocks + before.size() + m);
  return out;
}

std::vector<Found> points_of(const std::vector<Stand>& before, const std::vector<Stand>& now) {
  std::vector<Found> out;
  for (const Stand& stand : now) {
    if (!stand.cut) {  // points of sides come first, always the same ones
      out.emplace_back(out.size());
      continue;
    }
    const auto old = std::ranges::find_if(before, [&](const Stand& other) {
      return other.cut && other.cut->is_at(*stand.cut) && other.x == stand.x;
    });
    out.push_back(old == before.end() ? Found() : static_cast<std::size_t>(old - before.begin()));
  }
  return out;
}

std::size_t num_same(const std::vector<Cut>& before, const std::vector<Cut>& now) {
  const auto other = std::ranges::mismatch(
      before, now, [](const Cut& a, const Cut& b) { return a.is_at(b) && a.side == b.side; });
  return static_cast<std::size_t>(other.in1 - before.begin());
}

/// An equilibrium as it was.
struct Before {
  const std::vector<Stand>& points;
  const std::vector<Cut>& cuts;
};

Growth growth(const Before& before, const Equilibrium& now, const std::vector<Cut>& cuts) {
  return {.nodes = nodes_of(now.num_block_nodes(), now.num_nodes() - now.num_leading(),
                            through_blocks(before.cuts), through_blocks(cuts)),
          .points = points_of(before.points, stands(now, cuts)),
          .same_cuts = num_same(before.cuts, cuts)};
}

}  // namespace

Growth Growth::unchanged(const Equilibrium& equilibrium) {
  Growth out{.nodes = {}, .points = {}, .same_cuts = equilibrium.num_cuts()};
  for (std::size_t i = 0; i < equilibrium.num_nodes(); ++i) out.nodes.emplace_back(i);
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) out.points.emplace_back(p);
  return out;
}

std::vector<double> Growth::unknowns(const std::vector<double>& before) const {
  std::vector<double> out(block_unknowns * nodes.size(), 0.0);
  for (std::size_t node = 0; node < nodes.size(); ++node)
    if (nodes[node] && block_unknowns * *nodes[node] < before.size())
      std::copy_n(before.begin() + static_cast<std::ptrdiff_t>(block_unknowns * *nodes[node]), block_unknowns,
                  out.begin() + static_cast<std::ptrdiff_t>(block_unknowns * node));
  return out;
}

Growth CrackedStructure::remake(const std::vector<Cut>& before) {
  const std::vector<Stand> stood = stands(equilibrium_, before);
  const bool keeps_stiffness = equilibrium_.remake(body_, model_);
  Growth out = growth({stood, before}, equilibrium_, front_.geometry().cuts());
  out.keeps_stiffness = keeps_stiffness;
  return out;
}

std::pair<Equilibrium, Growth> CrackedStructure::tried(const std::vector<Cut>& before) const {
  std::pair<Equilibrium, Growth> out{Equilibrium(body_, model_, equilibrium_.history()), {}};
  out.second = growth({stands(equilibrium_, before), before}, out.first, front_.geometry().cuts());
  return out;
}

std::vector<Vec3> CrackedStructure::stress(const Loading& loading, std::span<const double> d,
                                           double load_factor) const {
  std::vector<Vec3> out;
  for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
    const Eigen::Map<const Vec3> strain(d.data() + block_unknowns * b + 3);
    out.emplace_back(body_.material(BlockId{b}).stiffness() * strain +
                     loading.initial_stress(b, load_factor));
  }
  return out;
}

BlockStress CrackedStructure::growing(const Loading& loading, const Place& at, const Place& rate) const {
  BlockStress out{stress(loading, at.d, at.load_factor), stress(loading, rate.d, rate.load_factor)};
  const std::vector<double> nothing(at.d.size(), 0.0);
  const std::vector<Vec3> initial = stress(loading, nothing, 0);
  for (std::size_t b = 0; b < initial.size(); ++b) out.live[b] -= initial[b];
  return out;
}

}  // namespace dda
