#include "continuation/handover/beginning.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "continuation/handover/side_ends.hpp"
#include "continuation/motion/motion.hpp"
#include "framework/base/errors.hpp"

namespace dda {
namespace {

/// As long as the deck says, or as it takes what falls by the size of the structure to come to rest.
double time_of(const MovingScene& scene, const MotionParameters& parameters, double pull) {
  constexpr double falls = 40;
  if (parameters.time > 0) return parameters.time;
  if (pull == 0)
    throw InputError(parameters.where,
                     "motion.time: nothing pulls at what moves; say how long it is to go on");
  Eigen::AlignedBox2d box;
  for (const MovingBody& body : scene.bodies)
    for (const Vec2& x : body.core) box.extend(body.centroid + x);
  return falls * std::sqrt(box.diagonal().norm() / pull);
}

}  // namespace

Beginning begin_motion(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters) {
  Beginning out{hand_over(pieces, end, parameters), {}};
  Handover& start = out.handover;
  const double pull = pull_on(start.scene, start.velocities);
  out.time = time_of(start.scene, parameters, pull);
  const double dt = parameters.step * pace_of(start.scene, pull);
  if (end.is_of_path && std::isfinite(dt)) {
    std::vector<Bond> bonds = start.bonds;
    std::ranges::move(ends_of_contacts(pieces), std::back_inserter(bonds));
    out.equilibrium = find_equilibrium(start.scene, bonds, start.poses, dt);
    start.poses = out.equilibrium.poses;
  }
  for (std::size_t b = 0; b < start.push.size(); ++b) start.scene.forces[b] += start.push[b];
  return out;
}

}  // namespace dda
