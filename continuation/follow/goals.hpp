#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

// Where a path has reached what it was to reach: decided here alone, of the equilibrium at which the walker
// stands, whatever has led to it.

/// A leg begins: gauges travel from here.
void set_out(PathState& path);

/// The walker heads for the goal of a leg that unloads, whatever the live forces push; it does not remember.
void set_heading(PathState& path);

void note_travel(PathState& path);

/// How much of its way since the leg began a gauge has gone.
double share_of_way(const PathState& path, const Landing& landing);
double share_of_goals(const PathState& path);

/// Whether the path has gone back since its peak while next to nothing cracked, less than a tenth of what had before, and
/// would soon bear the peak load again, for all that is known: the structure unloads.
bool has_turned_round(PathState& path);

/// The share of its peak that a structure which has turned round bears again; one that bears less has softened.
inline constexpr double still_borne = 0.75;

/// Whether the load has fallen to the share of its peak at which a path ends. One that acts the other way by more than that peak
/// has not.
bool has_fallen(PathState& path);

/// Whether a path that has turned round may be loaded again beyond its farthest way (reload_step): the control lets it, and no
/// such step has found too little.
bool may_reload(const PathState& path);

/// The end of a path that has turned round and has no way on.
std::optional<Point> stop_turned_round(PathState& path);

/// Ends the path where it has reached its goal, and begins the next leg where only the leg has, unless that has loads of
/// its own; and where a crack through blocks is stuck, which would make all that comes after too strong.
void settle(PathState& path);

/// Begins the leg with loads of its own that is due, and those after it that are, but not while a release goes on. The
/// equilibrium at which they begin belongs to the loads before: it is recorded first.
void begin_stages(PathState& path);

/// Begins the next leg, which has loads of its own, whatever the present one is to reach: these are held as they are.
void begin_stage(PathState& path, std::string reason);

/// Ends the path where nothing changes any more.
void look_for_standstill(PathState& path, const Point& point);

}  // namespace dda
