#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "continuation/bodies/meetings.hpp"

namespace dda {

inline Vec2 tangent_of(const Meeting& meeting) { return {-meeting.normal.y(), meeting.normal.x()}; }

/// The spring slider of friction at one meeting, its geometry that of the pass.
///
///     u = e + t · (motion of the vertex − motion of the foot, in the step)       [L]
///     V = ½ k_t u²  where k_t |u| ≤ μ N,   μ N (|u| − ½ μ N/k_t)  beyond
struct Slider {
  Meeting meeting;
  double start = 0;      ///< e
  double stiffness = 0;  ///< k_t [F/L]
  double bound = 0;      ///< μ N [F]

  Vec2 tangent() const { return tangent_of(meeting); }
  double reached(const Poses& before, const Poses& at) const;
  /// The force along t, and its derivative with respect to u.
  double force(double u) const { return std::clamp(stiffness * u, -bound, bound); }
  double slope(double u) const { return stiffness * std::abs(u) < bound ? stiffness : 0; }
  double stored(double u) const { return force(u) * force(u) / (2 * stiffness); }
  /// The elastic part that is left, e of the next step, and what the rest spends [F L].
  double kept(double u) const { return force(u) / stiffness; }
  double spent(double u) const { return bound * std::abs(u - kept(u)); }
};

/// Friction of a meeting that has slid in a step.
struct Slide {
  Meeting meeting;
  double at_start = 0, force = 0;  ///< along the tangent, at the start and at the end of the step [F]
  double slipped = 0;              ///< on the way from the start to the end [L]

  /// What it spends on it [F L], by the force of which that at the end is a share, along a way that leads `beyond` the end of
  /// the step: a body that gains speed goes less far between two middles of steps, over which its speed is booked, than from
  /// start to end.
  double spent_on_way(const Poses& beyond, double share_of_end) const;
};

/// The elastic slips e and normal forces N of the last accepted step, and the impacts that are under way.
class SliderMemory {
 public:
  struct Kept {
    double slip = 0;      ///< e [L]
    double force = 0;     ///< N [F]
    double approach = 0;  ///< speed at which they have met in an impact that is not over; 0: none [L/T]
  };

  void set(const MeetingKey& key, const Kept& kept) { kept_[key] = kept; }
  /// What was kept of this meeting, or of the same vertex at the next edge or corner of the same body.
  Kept of(const MeetingKey& key) const;
  const std::map<MeetingKey, Kept>& all() const { return kept_; }

 private:
  std::map<MeetingKey, Kept> kept_;
};

}  // namespace dda
