#pragma once

#include <vector>

#include "continuation/bodies/bonds.hpp"
#include "continuation/bodies/moving_scene.hpp"
#include "continuation/integrator/integrator.hpp"

namespace dda {

/// Bodies that bonds join, and what those of them do as one that bonds hold together.
class JoinedBodies {
 public:
  JoinedBodies() = default;
  JoinedBodies(const MovingScene& scene, const std::vector<Bond>& bonds);

  /// Whether a bond joins a body to another; it may be spent, and bear pressure.
  bool is_joined(std::size_t body) const { return is_joined_[body]; }

  /// By body, of a step in which accelerations ÿ have led to `reached`.
  std::vector<AsOne> as_one(const std::vector<BodyCourse>& start, const std::vector<Pose>& accelerations,
                            const Poses& reached) const;

 private:
  const MovingScene* scene_ = nullptr;
  std::vector<bool> is_joined_;
  std::vector<std::size_t> first_;  ///< that a body holds together with
  std::vector<bool> is_held_;       ///< by the first of those that hold together
};

}  // namespace dda
