#include "continuation/motion/joined_bodies.hpp"

#include "framework/base/disjoint_sets.hpp"

namespace dda {

JoinedBodies::JoinedBodies(const MovingScene& scene, const std::vector<Bond>& bonds)
    : scene_(&scene), is_joined_(scene.num_bodies(), false), is_held_(scene.num_bodies(), false) {
  DisjointSets sets(scene.num_bodies());
  for (const Bond& bond : bonds) {
    is_joined_[bond.first] = is_joined_[bond.second] = true;
    if (bond.holds()) sets.merge(bond.first, bond.second);
  }
  for (std::size_t b = 0; b < scene.num_bodies(); ++b) {
    first_.push_back(sets.representative(b));
    if (scene.bodies[b].is_held) is_held_[first_[b]] = true;
  }
}

std::vector<AsOne> JoinedBodies::as_one(const std::vector<BodyCourse>& start,
                                        const std::vector<Pose>& accelerations, const Poses& reached) const {
  std::vector<AsOne> out(start.size());
  std::vector<double> masses(start.size(), 0.0);
  for (std::size_t b = 0; b < start.size(); ++b) {
    if (is_held_[first_[b]]) continue;
    const double mass = scene_->bodies[b].block.mass;
    AsOne& sum = out[first_[b]];
    masses[first_[b]] += mass;
    sum.pull += scene_->load_on(b).head<2>();
    sum.before += mass * centre_of(start[b].acceleration);
    sum.now += mass * centre_of(accelerations[b]);
    sum.way += mass * (centre_of(reached[b]) - centre_of(start[b].now));
  }
  for (std::size_t b = 0; b < start.size(); ++b) {
    const std::size_t first = first_[b];  // at most b
    if (first == b && masses[b] > 0)
      out[b] = {out[b].pull / masses[b], out[b].before / masses[b], out[b].now / masses[b],
                out[b].way / masses[b]};
    out[b] = out[first];
  }
  return out;
}

}  // namespace dda
