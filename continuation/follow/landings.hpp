#pragma once

#include <optional>

#include "continuation/course/path_state.hpp"

namespace dda {

// Wanted values on which steps end exactly.

/// A wanted value that a step passes.
struct Crossing {
  Landing landing;
  double share;  ///< of the step, at which it lies
};

/// Those of the deck, of the leg, and the load below which the path ends.
std::vector<Landing> present_landings(const PathState& path);
/// Those of them at which the path or the leg ends, but for loads that are to fall.
std::vector<Landing> present_goals(const PathState& path);

/// The first that a step to the candidate passes.
std::optional<Crossing> first_crossing(const PathState& path, const Candidate& candidate);

/// The step that ends exactly there instead of beyond it.
std::optional<Point> land(PathState& path, const Candidate& beyond, const Crossing& crossing, StepKind kind);

/// Lands on a wanted value that lies before an event predicted `amount` ahead, by when no more than `most` is dissipated;
/// without it nothing from here on.
std::optional<Point> land_ahead(PathState& path, double amount, std::optional<double> most = {});

/// Along the leaving tangent to the first wanted value; infinite when none lies ahead.
double amount_to_landing(const PathState& path);

/// Lands there, however far it is; nothing when none lies ahead, or what is found is refused.
std::optional<Point> land_on_next(PathState& path);

/// Share of a step at which a point reaches its strength at which steps end; 1 when none does.
double share_to_strength(const PathState& path, const Candidate& candidate);

/// The equilibrium at which the first of those points stands exactly at its strength, before a state beyond.
std::optional<Candidate> at_strength(PathState& path, const Candidate& beyond, StepKind kind);

/// Lands there.
std::optional<Point> land_on_strength(PathState& path, const Candidate& beyond, StepKind kind);

/// Wanted values between which no equilibrium is recorded.
void report_passed(const PathState& path, const State& from, const State& to);

}  // namespace dda
