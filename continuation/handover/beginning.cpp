#include "continuation/handover/beginning.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "continuation/bodies/joined.hpp"
#include "continuation/handover/finite_poses.hpp"
#include "continuation/handover/handover.hpp"
#include "continuation/handover/side_ends.hpp"
#include "continuation/motion/motion.hpp"
#include "framework/base/errors.hpp"

namespace dda {
namespace {

/// As long as the deck says, or as it takes what falls by the size of the structure to come to rest.
double time_of(const MovingScene& scene, const MotionParameters& parameters, double pull) {
  constexpr double falls = 40;
  if (parameters.time > 0) return parameters.time;
  if (pull == 0) throw InputError(parameters.where, nothing_pulls);
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
  return hand_over(pieces, end, parameters);
}

}  // namespace

Beginning begin_motion(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters) {
  Beginning out{hand_over(pieces, end, parameters), {}};
  Handover& start = out.handover;
  const double pull = pull_on(start.scene, start.velocities);
  out.time = time_of(start.scene, parameters, pull);
  const double dt = parameters.step * pace_of(start.scene, pull);
  const bool is_loaded = end.is_of_path && std::isfinite(dt);
  Handover path = end.is_of_path ? as_on_path(pieces, end, parameters) : start;
  if (end.is_of_path) path.poses = start.poses = finite_poses(pieces, end, path);
  const SideEnds ends = ends_of_sides(pieces, end.equilibrium, path);
  for (Handover* of : {&path, &start}) {
    drop_spent(*of, ends.overlapping);
    of->bonds.insert(of->bonds.end(), ends.of_joints.begin(), ends.of_joints.end());
  }
  std::ranges::copy_if(ends.of_contacts, std::back_inserter(start.bonds), [&](const Bond& bond) {
    return std::ranges::binary_search(ends.overlapping, pair_of(bond));
  });
  if (!is_loaded) return out;
  path.bonds.insert(path.bonds.end(), ends.of_contacts.begin(), ends.of_contacts.end());
  out.equilibrium = find_equilibrium(path.scene, path.bonds, path.poses, dt);
  start.poses = out.equilibrium.poses;
  return out;
}

}  // namespace dda
