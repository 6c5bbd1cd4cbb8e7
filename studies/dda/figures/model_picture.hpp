#pragma once

#include <string>

#include "framework/files/run/run_folder.hpp"
#include "studies/dda/case/simulation.hpp"

namespace dda {

/// What a structure is, before anything moves, as an SVG text: blocks by material, interfaces that can crack or slide by
/// name, cuts, what holds it, the forces of each stage, and what gauges measure.
///
/// Symbols stand where the equations have them, not where the deck says: a row of six numbers that acts on a block is
/// dual to the displacement of one point (`acts_at`). Of moments and of what acts on all blocks the legend tells.
std::string model_picture(const Simulation& simulation);

/// The same as model.svg of a run folder, up to the blocks that figures show.
void write_model_picture(const RunFolder& folder, const Simulation& simulation);

/// Point and vector F of a force whose row Tᵀ F on a block's unknowns is given, its offset from the centroid:
///
///     f = (F_x, F_y, X F_y − Y F_x, X F_x, Y F_y, ½ (Y F_x + X F_y))
///
/// The offset that fits the row best, (F_x f₄ + F_y (f₆ + f₃/2), F_x (f₆ − f₃/2) + F_y f₅) / |F|²; several
/// forces on one block stand at their middle. Zero where there is no resultant.
struct ActingForce {
  Vec2 offset = Vec2::Zero(), force = Vec2::Zero();
};
ActingForce acts_at(const Vec6& row);

}  // namespace dda
