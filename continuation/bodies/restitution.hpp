#pragma once

#include <functional>
#include <vector>

#include "continuation/bodies/meetings.hpp"
#include "continuation/bodies/sliders.hpp"
#include "continuation/integrator/integrator.hpp"

namespace dda {

/// Bodies that joints hold together, as one rigid body: what an impact does to one of them it does to all.
struct RigidGroups {
  struct Group {
    double mass = 0, inertia = 0;  ///< [M], about the centroid [M L²]
    Vec2 centroid = Vec2::Zero();
    bool is_held = false;  ///< one of them is
  };
  std::vector<Group> groups;
  std::vector<std::size_t> of_body;  ///< its group

  /// As bodies stand at some poses; every body a group of its own but for those of `held_together`.
  RigidGroups(const MovingScene& scene, const std::vector<MeetingSearch::Pair>& held_together,
              const Poses& at);
};

/// Bodies that have met in a step.
struct Impact {
  const std::vector<Meeting>& meetings;                 ///< at its end
  const std::function<std::vector<Meeting>()>& before;  ///< at its beginning, asked for by impacts alone
  const SliderMemory& contacts;  ///< what was kept of them before: impacts that are under way
  const Poses& at;               ///< where all are then
  const Poses& approach;         ///< ẏ with which they have flown towards each other
  const Poses& velocity;         ///< ẏ that the step has left
  const Poses& pull;             ///< ÿ by the loads
  const Poses& way;              ///< that the step has led
  double step = 0;               ///< its length [T]
  double behind = 0;             ///< time by which ẏ, a mean, is behind [T]
  double slow = 0;               ///< approaches up to this are none [L/T]
  double span = 0;               ///< over which the forces at its end have acted [T]
  const RigidGroups& groups;     ///< at its end
  bool is_owed = false;          ///< impacts under way have given back less than they shall
};

/// What an impact does to bodies beside the forces of their contacts.
struct Rebound {
  std::vector<RigidMotion> given;  ///< by body; empty where nothing is
  std::vector<double>
      under_way;  ///< by meeting: the speed of approach of its impact; 0: none, or it is over [L/T]
};

/// Impulses along the normals after which bodies part with e times the speed at which they have met, none being pushed into
/// another: projected Gauss-Seidel on rigid motions of what joints hold together. They meet where the step has led them, with
///
///     v² = v₀² + 2 a s        v₀ at its beginning, a by the loads, s the way of the contact along its normal
///
/// whenever within the step that was, so that what bounces loses no height by the length of steps.
///
/// The step at whose end a contact has been approached gives what is missing of that speed, λ ≥ 0, with friction |λ_t| ≤ μ λ; so
/// do those after it, of an impact that takes several, as long as the energy that it has taken has not sufficed.
/// Contacts of the bodies that hit which bear no more at its end, such as the corner about which a body has turned over, have
/// borne until they did, since the middle of the last step, of which the velocity is: their forces then, with friction.
/// What springs have stored by then would have bodies part faster: as long as they bear on each other that is taken away,
/// at most what the force of the contact has given in the step, −λ ≤ N dt.
Rebound rebound(const MovingScene& scene, const Impact& impact);

}  // namespace dda
