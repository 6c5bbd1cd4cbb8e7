#pragma once

#include <string>

#include "continuation/course/path_state.hpp"

namespace dda {

// Structures that move on while their load stays.

/// Share of its displacement by which a mechanism moves on while the load stays.
inline constexpr double mechanism_way = 0.1;

/// Whether only the weak springs hold the structure any more: it moves far beyond what it did under its peak.
bool is_mechanism(const PathState& path, const State& state);

/// Load factor beyond the present one at which the next point reaches its strength; infinite where none does,
/// and where strength is lost at once also where what slides and turns goes on as a mechanism long before.
double amount_to_event(const PathState& path);

/// Whether joints may slide, open or close although nothing cracks. Where strength may yet be lost at once
/// the release finds what follows.
bool can_slide(const PathState& path);

/// How far the displacement on which the load works is from where the leg has begun.
double way_of_leg(const PathState& path, const State& state);

/// By how much a load may change that stays.
double standing_load(const PathState& path, double load);

/// Rate of the load along the leaving tangent without what the residual stiffness of free joints takes: of a mechanism
/// only that is in it.
double load_rate(const PathState& path);

/// Whether the structure moves on by as much as makes a mechanism while its load stays.
bool moves_freely(const PathState& path);

/// Whether the load grows with the displacement a thousand times more slowly than it has so far: near the angle at which
/// joints wedge, what residual stiffness is left of those that slide takes so much.
bool hardly_resists(const PathState& path);

/// Whether what slides where a stage begins takes next to none of its load, however small.
bool hardly_resists_at_once(const PathState& path);

/// Whether what has cracked would bear its peak load again, nothing cracking or sliding on, by at most so many times its
/// largest displacement so far: no rupture, whatever load is left. Weight on a crack that friction holds does.
bool bears_load(PathState& path, double within = 10);

/// How far joints in contact move from one state to another where the load and the displacement on which it works stay [L]; 0 where
/// these move on as well: what slides under other loads, as a weight on a slope that is lifted, moves beside the load.
double way_beside_load(const PathState& path, const State& from, const State& to);

/// Whether the last step has moved so, or the next one will: joints move far more than the load does, and but for weak springs
/// the load stays.
bool goes_beside_load(const PathState& path);

/// Why a step that moves joints far beside the load is too long; "" when it is not, and where that is what is prescribed.
std::string too_far_beside_load(const PathState& path, const Candidate& candidate);

/// Prescribes the displacement on which the load works, which goes on where the load does not.
Move displacement_move(const PathState& path);

/// Where a step has begun.
struct Departure {
  State state;
  double dissipated = 0;  ///< [FL]

  explicit Departure(const Walker& walker) : state(walker.state()), dissipated(walker.here().dissipated) {}
};

/// Whether no joint closes before the structure has moved on by a hundred times its displacement, or it has done so, or moved by
/// as much as small displacements may be: where joints have come apart under loads before, gaps close on the way and lock what
/// seems a mechanism.
bool is_free_beyond(const PathState& path);

/// Where the last step, from `before`, has moved the structure on by so much while its load stayed, or several have, it is a
/// mechanism. One that is free beyond ends the path, unless it brings a gauge nearer to what is wanted of it.
void note_mechanism(PathState& path, Point& point, const Departure& before);

}  // namespace dda
