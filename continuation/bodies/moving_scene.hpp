#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "models/contact/contact_law.hpp"
#include "models/kinematics/affine.hpp"
#include "models/time_function/time_function.hpp"

namespace dda {

/// Where all bodies are.
using Poses = std::vector<Pose>;

/// The farthest that any centroid has moved [L].
inline double farthest(const Poses& from, const Poses& to) {
  double out = 0;
  for (std::size_t b = 0; b < from.size(); ++b)
    out = std::max(out, (centre_of(to[b]) - centre_of(from[b])).norm());
  return out;
}

/// The six components of a body in a vector of forces.
template <class Vector>
auto of_body(Vector& v, std::size_t body) {
  return v.template segment<6>(6 * static_cast<Eigen::Index>(body));
}

/// A body that moves: inertia and stiffness, and the core that meets those of others.
struct MovingBody {
  AffineBlock block;
  Vec2 centroid = Vec2::Zero();  ///< undeformed [L]
  std::vector<Vec2> core;        ///< vertices, counter-clockwise, from the undeformed centroid [L]
  std::vector<Vec2> outline;     ///< the same of the body itself
  double size = 0;               ///< √area [L]
  double modulus = 0;            ///< E [F/L²], for the stiffness of contacts
  bool is_held = false;          ///< it stays where it is, or goes where it is driven

  Pose undeformed() const { return pose_of(centroid, Mat2::Identity()); }
};

/// A spring on material points: ½ k (Σ rowᵀ y_body − length)².
struct MotionSpring {
  std::vector<std::pair<std::size_t, Vec6>> rows;  ///< body, and what of its pose counts
  double length = 0;                               ///< [L]
  double stiffness = 0;                            ///< [F/L]

  double stretch(const Poses& at) const {
    double out = -length;
    for (const auto& [body, row] : rows) out += row.dot(at[body]);
    return out;
  }
};

/// Held bodies that are moved.
struct Drive {
  std::vector<std::size_t> bodies;
  Vec2 direction;                                    ///< unit
  std::shared_ptr<const TimeFunction> displacement;  ///< [L]
};

/// How bodies meet.
struct MeetingRules {
  std::shared_ptr<const ContactLaw> law;
  double reach = 0;              ///< 2s: cores that are nearer overlap as bodies [L]
  double stiffness = 10;         ///< α
  double shear_stiffness = 0.1;  ///< of the slider of friction, as a share of k
  /// tan φ of two bodies, and with what share of the speed at which they have met they part; none: 0.
  std::function<double(std::size_t, std::size_t)> friction, restitution = nullptr;
};

/// What moves and what acts on it.
struct MovingScene {
  std::vector<MovingBody> bodies;
  std::vector<MotionSpring> springs = {};
  std::vector<Vec6> forces = {};  ///< dead, by body, dual to its pose; empty when there are none
  std::vector<Drive> drives = {};
  Vec2 gravity = Vec2::Zero();  ///< [L/T²]
  double thickness = 1;         ///< [L]
  double smallest = 0;  ///< size of bodies by which time steps go; 0: that of the smallest that moves [L]
  MeetingRules meeting;
  /// Bodies that have a corner in common: those which a chain of joints connects around it do not meet.
  std::vector<std::vector<std::uint32_t>> around = {};

  std::size_t num_bodies() const { return bodies.size(); }
  /// What acts on a body, its weight included: constant.
  Vec6 load_on(std::size_t body) const {
    Vec6 out = forces.empty() ? Vec6(Vec6::Zero()) : forces[body];
    out.head<2>() += bodies[body].block.mass * gravity;
    return out;
  }
};

}  // namespace dda
