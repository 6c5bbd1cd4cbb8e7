#pragma once

#include <nlohmann/json_fwd.hpp>

#include "studies/dda/record/warnings/bearings.hpp"

namespace dda {

/// A small piece of the structure with a bearing that has come off it, wholly or nearly.
struct TornPiece {
  Bearing bearing;
  std::vector<BlockId> blocks;
  double share = 0;  ///< of all energy spent: around the piece
};

/// Bearings that a history has torn out of the structure:
///
///     joints that have lost nine tenths of their strength cut them off with at most a twentieth of the
///     structure, which itself has not parted, or spent less energy than they
///     where the load has fallen: half of all energy was spent within 2.5 sizes of their blocks
std::vector<TornPiece> torn_pieces(const Simulation& simulation, const std::vector<History>& history,
                                   bool has_fallen);

/// What happened, what the peak is then, and what to do.
std::string text(const Simulation& simulation, const TornPiece& piece);

/// For summary.json: name, blocks by number, centroid, share.
nlohmann::ordered_json to_json(const Simulation& simulation, const std::vector<TornPiece>& pieces);

}  // namespace dda
