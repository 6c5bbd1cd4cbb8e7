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

/// The structure as the path has left it: under all of its loads, on its supports.
Handover as_on_path(const Pieces& pieces, const PathEnd& end, MotionParameters parameters) {
  parameters.loads = KeptLoads::all;
  parameters.keeps_supports = true;
  parameters.push = 0;
  parameters.gravity.setZero();
  Handover out = hand_over(pieces, end, parameters);
  std::ranges::move(ends_of_contacts(pieces), std::back_inserter(out.bonds));
  return out;
}

}  // namespace

Beginning begin_motion(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters) {
  Beginning out{hand_over(pieces, end, parameters), {}};
  Handover& start = out.handover;
  const double pull = pull_on(start.scene, start.velocities);
  out.time = time_of(start.scene, parameters, pull);
  const double dt = parameters.step * pace_of(start.scene, pull);
  if (end.is_of_path && std::isfinite(dt)) {
    const Handover path = as_on_path(pieces, end, parameters);
    out.equilibrium = find_equilibrium(path.scene, path.bonds, path.poses, dt);
    start.poses = out.equilibrium.poses;
  }
  return out;
}

}  // namespace dda
