#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuation/integrator/integrator.hpp"
#include "continuation/motion/energy/damping.hpp"
#include "framework/deck/schema.hpp"
#include "models/contact/contact_law.hpp"
#include "models/time_function/time_function.hpp"

namespace dda {

/// What becomes of the loads of the path when the structure is let go.
enum class KeptLoads { all, dead };

/// Names of regions, and where each stands in the deck.
struct RegionNames {
  std::vector<std::string> names;
  std::vector<Position> where;
};

/// What two materials do where their bodies meet.
struct PairParameters {
  std::vector<std::string> between;
  std::optional<double> friction, restitution;
  Position where;
};

/// Regions that begin with a velocity of their own: each turns about its centroid.
struct VelocityParameters {
  std::vector<std::string> regions;
  Vec2 velocity = Vec2::Zero();  ///< [L/T]
  double spin = 0;               ///< [1/T]
  Position where;
};

/// Held regions that are moved.
struct DriveParameters {
  std::vector<std::string> regions;
  Vec2 direction = Vec2::Zero();
  TimeFunctionChoice displacement;
  Position where;
};

/// How bodies meet in motion.
struct MeetingParameters {
  ContactLawChoice law;
  double stiffness = 10;
  double offset = 1e-3;  ///< s over √area of the smallest block
  /// tan φ where no interface and no pair says anything else; none: that of all interfaces.
  std::optional<double> friction;
  double restitution = 0;
  std::vector<PairParameters> pairs;
  Position where;
};

/// The deck's `motion` section: what happens where the path has ended, or from the undeformed structure on.
struct MotionParameters {
  double time = 0;  ///< at most so long [T]; 0: as long as it takes
  bool stops_at_rest = true;
  KeptLoads loads = KeptLoads::all;
  bool keeps_supports = true;
  double push = 0.01;  ///< share by which the last load grows at the beginning, where it has been falling
  Vec2 gravity = Vec2::Zero();  ///< [L/T²]
  RegionNames held;             ///< regions that stay where they are
  std::vector<DriveParameters> driven;
  std::vector<VelocityParameters> velocities;
  IntegratorChoice integrator;
  DampingRates damping;
  MeetingParameters contact;
  double step = 0.01;                   ///< in √(L/g)
  std::optional<double> accuracy = {};  ///< of places in a step, in sizes of their bodies
  double frame_every = 0;               ///< [T]; 0: by how long it takes
  Position where;
};

Schema<MotionParameters> motion_schema();

}  // namespace dda
