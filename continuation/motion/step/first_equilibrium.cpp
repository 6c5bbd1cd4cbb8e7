#include "continuation/motion/step/first_equilibrium.hpp"

#include <algorithm>

#include "continuation/bodies/joined.hpp"
#include "continuation/motion/step/step_minimum.hpp"

namespace dda {
namespace {

double work_of_loads(const MovingScene& scene, const Poses& from, const Poses& to) {
  double out = 0;
  for (std::size_t b = 0; b < from.size(); ++b) out += scene.load_on(b).dot(to[b] - from[b]);
  return out;
}

}  // namespace

FirstEquilibrium find_equilibrium(const MovingScene& scene, const std::vector<Bond>& bonds,
                                  const Poses& poses, double dt) {
  std::vector<MeetingSearch::Pair> apart = joined_by(bonds, scene.around);
  for (const Bond& bond : bonds)
    if (bond.is_end) apart.push_back(pair_of(bond));
  std::ranges::sort(apart);
  const MeetingSearch search(scene, std::move(apart));
  Potential potential(scene, search, bonds);
  potential.set_histories(Potential::Histories::frozen);
  potential.begin(poses);
  const double before = potential.stored(poses).sum();
  StepMinimum solver(scene, potential, {});
  std::vector<BodyCourse> at_rest;
  for (const Pose& y : poses) at_rest.push_back({y, y});
  MotionStep found = solver.solve({poses, at_rest, {}}, {poses, poses, 1 / (dt * dt)});
  FirstEquilibrium out{
      .poses = poses, .contacts = {}, .iterations = found.iterations, .failure = found.failure};
  if (!found.converged()) return out;
  out.poses = found.poses;
  out.moved = farthest(poses, out.poses);
  out.contacts = std::move(found.contacts);
  double after = potential.stored(out.poses).sum();
  for (std::size_t i = 0; i < bonds.size(); ++i)
    if (!bonds[i].law->releases_at_once())
      after += spending(bonds[i], potential.state_of(i, out.poses)) -
               spending(bonds[i], potential.state_of(i, poses));
  out.released = before + work_of_loads(scene, poses, out.poses) - after;
  return out;
}

}  // namespace dda
