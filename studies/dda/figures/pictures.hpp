#pragma once

#include "framework/figure/plot.hpp"
#include "framework/files/run/run_folder.hpp"
#include "studies/dda/case/deck/deck.hpp"
#include "studies/dda/record/run_memory.hpp"
#include "studies/dda/record/warnings/torn_pieces.hpp"

namespace dda {

/// Blocks beyond which none are drawn: a picture would be too large for a browser.
inline constexpr std::size_t most_drawn_blocks = 20000;

/// By how much displacements are enlarged in pictures: the largest is about 5 % of the structure.
double magnification(const Fields& fields, const State& state);

/// What the pictures of a run show beside its curve.
struct PictureContent {
  const RunMemory& memory;
  const StoredState& end;
  const RecordParameters& record;
  const std::vector<TornPiece>& torn;
};

/// curve.svg and, up to 20 000 blocks, deformed.svg of a run; the curve is read back from curve.csv. Where
/// the deck asks for it detail.svg: the blocks of a rectangle at the end, without what they move together.
/// Blocks that have been torn out have a red outline.
/// There cracks are coloured by their opening, max(w_n, 0), in deformed-sliding.svg and detail-sliding.svg by
/// their sliding, |w_s|.
void write_pictures(const RunFolder& folder, const Fields& fields, const Measures& measures,
                    const PictureContent& content);

}  // namespace dda
