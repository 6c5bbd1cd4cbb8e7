#pragma once

#include <optional>
#include <string>

#include "continuation/control/control.hpp"
#include "continuation/course/path_state.hpp"
#include "continuation/follow/place_before.hpp"

namespace dda {

// The kinds of steps. Each goes from where the walker stands to the next point of the path; nothing where the path
// has ended.

/// A step under the control where cracks grow or joints slide: tries, and the rungs that each converged one
/// climbs (rungs.hpp), until one ends the step; where the smallest does not, a rescue or the end.
std::optional<Point> controlled_step(PathState& path, const Move& move);

/// Nothing cracks yet: to where the next crack starts, or as far towards it as contacts let one step go.
std::optional<Point> event_step(PathState& path);

/// Nothing can crack any more: the response is linear up to the full reference load.
std::optional<Point> linear_step(PathState& path);

/// Nothing cracks, but joints slide, open or close. The first change of a contact is landed on; from there
/// the path is followed until a wanted value or a mechanism. Where no contact will change any more the
/// response is linear for good.
std::optional<Point> sliding_step(PathState& path);

/// Lands on zero load: where the last crack of the structure breaks. Unloading ends there, too, and what
/// slides back dissipates.
std::optional<Point> rupture(PathState& path);

/// At most a tenth of the leg's way towards its goal, off the damage surfaces.
std::optional<Point> unload_step(PathState& path);

/// Next vertex of an instantaneous release; where no continuous path leads on, what a test would find after a
/// jump.
std::optional<Point> release_step(PathState& path);

/// The crack that stress asks for where the walker stands, once something has cracked.
std::optional<CrackFront::Asked> crack_to_start(PathState& path);

/// Cuts its first segment, closed, and stands at the same displacement of the load; what that differs by is booked as
/// a jump. Nothing, and nothing changed, where it cannot be cut.
std::optional<Point> start_step(PathState& path, const CrackFront::Asked& asked);

/// The crack through blocks whose segment ahead has a point at its strength where the walker stands; nothing when
/// there is none.
std::optional<int> crack_to_grow(PathState& path);

/// Takes the segment ahead of a crack as grown and cuts the next one; then the equilibrium in which the first of all
/// points stands at its strength, their damage staying as it is. Closed cuts are all but rigid, so that this is hardly
/// another state; what it differs by is booked as a jump. Where it lies far away, since a point of the new segment is
/// beyond its strength when it appears, a step goes on from the state as it is, or, where nothing leads on, the load's
/// displacement is held while damage grows; where neither is found the load falls there.
std::optional<Point> growth_step(PathState& path, int crack);

/// Aims the segment ahead of a crack once more, by the stress where its first point has reached its strength. Where that
/// makes another one of it the path goes back to the place before, since a segment that is aimed better reaches its
/// strength earlier. Nothing where it is aimed well, where energy had been spent on it before or there is no
/// equilibrium with the other one, and the path stays; nothing, too, where that place is the structure at rest, from which
/// the step is to be taken again.
std::optional<Point> aim_step(PathState& path, int crack, const PlaceBefore& before);

/// The load raised by the largest of halved increments that still finds an equilibrium.
std::optional<Point> increment_step(PathState& path);

/// Event control's step: sequentially linear ones until something has been dissipated.
std::optional<Point> sequential_step(PathState& path);

/// A rescue, where no continuous path leads on or none is found: the largest of some steps of the displacement on which
/// the load works that ends in an equilibrium, what is beyond its strength there released at once, or its damage grown
/// (staggered.hpp).
std::optional<Point> jump_step(PathState& path);

/// A rescue, where the load has fallen by a quarter and the path seems to have turned round: of the branches that leave an
/// equilibrium with friction one unloads. A jump to beyond the farthest displacement of the load if its peak is borne again there, or,
/// where the path would end, what is no rupture. Nothing where less is borne: the structure has softened, and goes back as brittle
/// ones do. Tried once up to each farthest way, and once more where the path would end.
std::optional<Point> reload_step(PathState& path);

/// The end where nothing is found any more: rupture if hardly any load is left.
std::optional<Point> end_without_equilibrium(PathState& path, Stop stop, const std::string& why);

}  // namespace dda
