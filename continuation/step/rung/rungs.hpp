#pragma once

#include <array>
#include <optional>
#include <string>

#include "continuation/course/path_state.hpp"
#include "continuation/follow/turns.hpp"

namespace dda {

/// A step is tried again with this share of its size when Newton fails.
inline constexpr double cut = 0.25;
/// Below this share of its first size a step is given up.
inline constexpr double smallest_share = 1e-4;

/// One step under a control while its length is sought.
struct Stride {
  /// What the try before has left unaccounted for.
  struct Before {
    double amount = 0;  ///< its length; 0 when there was none
    double lost = 0;    ///< [FL]
  };

  const Move& move;
  double amount = 0;   ///< length of the next try along the leaving tangent
  double natural = 0;  ///< of the first one, where nothing speaks for less
  double beyond =
      0;  ///< what the try would have been long, had it not ended at a strength; 0 when it has not
  std::string why = {};  ///< it has been shortened last
  int cuts = 0;          ///< how often it has failed
  int refinements = 0;   ///< how often for the peak, a turn or the balance of energy
  int looks = 0;         ///< and to look between its ends
  double looked_at = 0;
  bool is_ordered = false;  ///< it has been shortened for the order in which cracks begin
  Looks looked = {};
  Before before = {};
};

/// What a rung has made of a try: the point where the step ends; none when the step is to be tried again, the
/// stride being shorter now.
struct Outcome {
  std::optional<Point> point;
};

/// What may be said of a converged try; nothing where this rung has no say.
using Rung = std::optional<Outcome> (*)(PathState& path, const Candidate& candidate, Stride& stride);

// Rungs by which a converged try ends the step: at it, or exactly at what lies before it.

/// At the first equilibrium that another branch leaves.
std::optional<Outcome> stop_at_branch(PathState& path, const Candidate& candidate, Stride& stride);
/// On the first wanted value on the way.
std::optional<Outcome> land_on_value(PathState& path, const Candidate& candidate, Stride& stride);
/// Where the first point that loses its strength at once reaches it.
std::optional<Outcome> land_at_strength(PathState& path, const Candidate& candidate, Stride& stride);
/// At the try itself; the next step is sized by it.
std::optional<Outcome> go_on(PathState& path, const Candidate& candidate, Stride& stride);

// Rungs that take a converged try back because a shorter step sees more. Each may do so a few times in a
// step.

/// The try lies far from what the tangent foresaw: another branch, perhaps.
std::optional<Outcome> refuse_stray(PathState& path, const Candidate& candidate, Stride& stride);
/// A crack has begun and overtaken one that the tangent lets begin before it: another branch, perhaps, as there is one for
/// each of several cracks that compete.
std::optional<Outcome> keep_order(PathState& path, const Candidate& candidate, Stride& stride);
/// The limit point lies on the way and is not bracketed yet.
std::optional<Outcome> bracket_peak(PathState& path, const Candidate& candidate, Stride& stride);
/// A displacement gauge turns on the way.
std::optional<Outcome> bracket_turn(PathState& path, const Candidate& candidate, Stride& stride);
/// A peak or a turn may be hidden on the way.
std::optional<Outcome> look_between(PathState& path, const Candidate& candidate, Stride& stride);
/// The quadrature of the work misses a kink, or joints have snapped.
std::optional<Outcome> refine_coarse(PathState& path, const Candidate& candidate, Stride& stride);

// What they share.

inline constexpr int most_refinements = 20;  ///< of one step

/// Tries again with a share of the step, which sees more, where there is such a share, some times in a step.
std::optional<Outcome> bracket(PathState& path, Stride& stride, const std::optional<double>& share,
                               const std::string& what);
/// Tries again with a share of the step.
Outcome shorten(PathState& path, Stride& stride, const std::string& why, double share);
/// Tries again before what lies at a share of the step and could not be landed on.
Outcome stop_short(Stride& stride, std::string why, double share);
/// Share of the way to where the next point reaches its strength, where that is to be landed on; else 1.
double share_to_awaited(const PathState& path, const Candidate& candidate);

/// What is asked of a converged try, one after another; the first that has a say decides.
inline constexpr std::array<Rung, 10> rungs{refuse_stray,     keep_order,    bracket_peak,   bracket_turn,
                                            look_between,     refine_coarse, stop_at_branch, land_on_value,
                                            land_at_strength, go_on};

// What they and failed tries lead to.

/// Accepts what a step has jumped to where joints snap: most of what such a jump leaves unaccounted for is
/// left however short the step is, as two of its sizes tell, while that of a kink vanishes with it. How much
/// of the energy that it sets free friction takes on the way is not known.
std::optional<Point> snap(PathState& path, const Candidate& beyond, Stride& stride);

/// Where a step fails because the path turns on the way: lands exactly where a crack starts or has lost its
/// last traction, so that the tangent there tells which cracks go on and which unload.
std::optional<Point> land_on_turn(PathState& path, const Stride& stride, bool on_new_cracks);

/// Where a step of this length along which cracks grow, or one of arc length or of a gauge that is prescribed, cut before,
/// fails because a joint begins to slide or to stick, opens or closes on the way, after which the path may turn: lands a
/// hair beyond the first such change, so that the tangent there tells which joints go on.
std::optional<Point> land_on_contact_change(PathState& path, double amount, StepKind kind);

/// Where a step moves joints far while the load and the displacement on which it works stay: a little beyond the next change
/// of a joint, by that joint's opening.
std::optional<Point> slide_beside_load(PathState& path);

}  // namespace dda
