#include "verification/double_cantilever.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "verification/support.hpp"

namespace dda::verification {

std::string DoubleCantilever::deck() const {
  return fmt::format(R"(
scene:
  regions:
    - {{name: upper, material: concrete, vertices: [[0, 0], [{0}, 0], [{0}, {1}], [0, {1}]]}}
    - {{name: lower, material: concrete, vertices: [[0, -{1}], [{0}, -{1}], [{0}, 0], [0, 0]]}}
  curves: {{ligament: [[{2}, 0], [{0}, 0]]}}
  slits: {{notch: [[0, 0], [{2}, 0]]}}
  boundaries:
    upper_outer: [[0, {1}], [0, {3}]]
    upper_inner: [[0, {3}], [0, 0]]
    lower_inner: [[0, 0], [0, -{3}]]
    lower_outer: [[0, -{3}], [0, -{1}]]
  subdivision: {{type: grid, columns: {4}, rows: {5}}}
thickness: {6}
kinematics: {10}
materials: {{concrete: {{type: linear_elastic, young_modulus: {7}, poisson_ratio: 0.2}}}}
interfaces:
  ligament: {{law: {{type: linear_softening, tensile_strength: {8}, fracture_energy: {9}}}}}
supports:
  pin: {{at: [{0}, -{1}], fix: xy}}
  roller: {{at: [{0}, {1}], fix: x}}
stages:
  - loads:
      - {{type: edge_traction, boundary: upper_outer, traction: [1, 0]}}
      - {{type: edge_traction, boundary: upper_inner, traction: [-1, 0]}}
      - {{type: edge_traction, boundary: lower_inner, traction: [-1, 0]}}
      - {{type: edge_traction, boundary: lower_outer, traction: [1, 0]}}
path: {{step: {{accuracy: 0.002}}, stop: {{load_below: 0.8, after_steps: 300}}}}
)",
                     length, arm_height, crack, arm_height / 2, std::lround(rows * length / arm_height), rows,
                     width, young, strength, energy, kinematics);
}

double DoubleCantilever::mean_plateau() const {
  const Trace trace = follow(deck());
  const double all = energy * width * (length - crack);
  double sum = 0, spent = 0;
  for (std::size_t i = 1; i < trace.points.size(); ++i) {
    const Traced &from = trace.points[i - 1], &to = trace.points[i];
    if (from.dissipated < 0.21 * all || to.dissipated > 0.64 * all) continue;
    const double quantum = to.dissipated - from.dissipated;
    sum += quantum * 0.5 * (from.state.load_factor + to.state.load_factor);
    spent += quantum;
  }
  if (spent < 0.3 * all) throw std::runtime_error("the path ended early: " + trace.ending.reason);
  return sum / spent * width * arm_height * arm_height / 4 / moment();
}

}  // namespace dda::verification
