#include "verification/chain.hpp"

#include <fmt/format.h>

namespace dda::verification {
namespace {

constexpr double side = Chain::side;

std::string scene(std::size_t blocks) {
  std::string out = "scene:\n  regions:\n";
  for (std::size_t i = 0; i < blocks; ++i) {
    const double left = static_cast<double>(i) * side;
    out += fmt::format(
        "    - {{name: block{0}, material: concrete, vertices: [[{1}, 0], [{2}, 0], [{2}, {3}], [{1}, "
        "{3}]]}}\n",
        i, left, left + side, side);
  }
  out += "  curves:\n";
  for (std::size_t i = 1; i < blocks; ++i)
    out += fmt::format("    joint{0}: [[{1}, 0], [{1}, {2}]]\n", i - 1, static_cast<double>(i) * side, side);
  return out + fmt::format("  boundaries: {{left: [[0, 0], [0, {0}]], right: [[{1}, 0], [{1}, {0}]]}}\n",
                           side, static_cast<double>(blocks) * side);
}

double centroid(std::size_t block) { return (static_cast<double>(block) + 0.5) * side; }

}  // namespace

std::string Chain::pull() {
  return "  - {name: pull, loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}\n";
}

std::string Chain::deck() const {
  const std::size_t blocks = laws.size() + 1;
  std::string out = scene(blocks);
  out += fmt::format(
      "thickness: {}\nmaterials: {{concrete: {{type: linear_elastic, young_modulus: {}, poisson_ratio: "
      "0}}}}\ninterfaces:\n",
      side, young);
  for (std::size_t i = 0; i < laws.size(); ++i)
    out += fmt::format("  joint{}: {{points: midpoint, treatment: {}, law: {}}}\n", i, treatment, laws[i]);
  out += "supports:\n";
  if (held_left) out += "  wall: {boundary: left, fix: x}\n";
  for (const auto& [block, stiffness] : springs)
    out += fmt::format("  spring{0}: {{at: [{1}, {2}], fix: x, stiffness: {3:.17g}}}\n", block,
                       centroid(static_cast<std::size_t>(block)), side / 2, stiffness);
  for (std::size_t i = 0; i < blocks; ++i)
    out += fmt::format("  y{0}: {{at: [{1}, {2}], fix: y}}\n  turn{0}: {{at: [{1}, {2}], fix: rotation}}\n",
                       i, centroid(i), side / 2);
  const double length = static_cast<double>(blocks) * side;
  out += "stages:\n" + stages +
         fmt::format(
             "gauges:\n  elongation: {{type: relative_displacement, from: [0, {0}], to: [{1}, {0}]}}\n"
             "  tip: {{type: displacement, at: [{1}, {0}], direction: [1, 0]}}\n",
             side / 2, length);
  for (std::size_t i = 0; i < blocks; ++i)
    out += fmt::format("  x{}: {{type: displacement, at: [{}, {}], direction: [1, 0]}}\n", i, centroid(i),
                       side / 2);
  return out + "path: " + path + "\n";
}

}  // namespace dda::verification
