#include "continuation/motion/step/step_solver.hpp"

#include <algorithm>

namespace dda {

double force_scale(const MovingScene& scene, const Poses& start, const Inertia& inertia) {
  constexpr double of_inertia = 1e-3;
  double out = 0;
  for (std::size_t b = 0; b < start.size(); ++b) {
    if (scene.bodies[b].is_held) continue;
    const MovingBody& body = scene.bodies[b];
    const Vec6 flown = inertia.per_square_time * body.block.times_mass(inertia.flight[b] - start[b]);
    out = std::max({out, scene.load_on(b).head<2>().norm(), of_inertia * flown.head<2>().norm(),
                    of_inertia * flown.tail<4>().norm() / body.size});
  }
  return out;
}

Unbalanced unbalanced(const MovingScene& scene, const Eigen::VectorXd& forces,
                      const std::vector<double>& rounding) {
  Unbalanced out;
  for (std::size_t b = 0; b < scene.num_bodies(); ++b) {
    const double now = std::max(0.0, left_of(of_body(forces, b), scene.bodies[b].size) - rounding[b]);
    if (!(now <= out.force)) out = {now, b};
  }
  return out;
}

}  // namespace dda
