#pragma once

#include <span>

#include "continuation/bodies/bonds.hpp"
#include "continuation/bodies/meetings.hpp"
#include "continuation/handover/motion_parameters.hpp"
#include "continuation/handover/pieces.hpp"
#include "continuation/state/system.hpp"

namespace dda {

/// What a motion begins with: the last state of a path, in finite rotations.
///
///     c = X0 + (u0, v0),   F = R(r0) (I + ε)
///
/// Parts of blocks that cracks have cut are bodies of their own; their joints are springs with what they bear at the
/// handover as an offset. Joints that still hold stay, with their histories; where nothing is left of one, bodies meet. Loads stay as dead
/// forces on material points, supports as springs.
struct Handover {
  MovingScene scene;
  std::vector<Bond> bonds;
  std::vector<Bond> touching;  ///< of joints that hold nothing: bodies meet there
  Poses poses, velocities;
  bool is_pushed = false;
  double offset = 0;  ///< s [L]
};

/// Why a motion until rest is none that nothing sets going.
inline constexpr const char* nothing_pulls =
    "motion.time: nothing pulls at what moves; say how long it is to go on";

/// Throws InputError for what could not be handed over: materials without density, blocks narrower than their offset.
void require_handover(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters,
                      const ModelParameters& model);

/// Where a path has ended; without a path the undeformed structure, under no load.
struct PathEnd {
  const Equilibrium& equilibrium;
  const State& state;
  std::span<const History> history;  ///< of every active point
  bool is_of_path = false;           ///< else the undeformed structure
  bool has_fallen = false;           ///< the load was falling, or could not grow

  const Loading& loading() const { return equilibrium.stages().back(); }
};

/// Throws InputError where a crack has left a part that is too narrow for any core.
Handover hand_over(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters);

/// What has cracked through, or only touches, bears pressure where something else still holds the bodies, or where a pair is
/// kept, in order; elsewhere bodies meet, and bonds of which nothing is left are dropped.
void drop_spent(Handover& from, const std::vector<MeetingSearch::Pair>& kept);

}  // namespace dda
