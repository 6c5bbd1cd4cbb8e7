#pragma once

#include <string>
#include <vector>

#include "framework/deck/schema.hpp"
#include "models/contact/contact_law.hpp"

namespace dda {

/// What becomes of the loads of the path when the structure is let go.
enum class KeptLoads { all, dead };

/// How bodies meet in motion.
struct MeetingParameters {
  ContactLawChoice law;
  double stiffness = 10;
  double offset = 1e-3;  ///< s over √area of the smallest block
  double friction = 0;   ///< tan φ where no interface says anything else
};

/// The deck's `motion` section: what happens where the path has ended.
struct MotionParameters {
  double time = 0;  ///< at most so long [T]
  bool stops_at_rest = true;
  KeptLoads loads = KeptLoads::all;
  bool keeps_supports = true;
  double push = 0.01;  ///< share by which the last load grows at the beginning, where it has been falling
  Vec2 gravity = Vec2::Zero();    ///< [L/T²]
  std::vector<std::string> held;  ///< regions that stay where they are
  MeetingParameters contact;
  double step = 0.01;      ///< in √(L/g)
  double frame_every = 0;  ///< [T]; 0: a hundredth of `time`
  Position where;
};

Schema<MotionParameters> motion_schema();

}  // namespace dda
