#pragma once

#include "studies/dda/case/deck/deck.hpp"

namespace dda {

/// Throws InputError, at its key in the tree of the deck, for every name of a gauge that there is none of, in `path.load_gauge`,
/// `path.stop.gauges`, `record.at`, `record.reference_peak.at` and `until` of the stages, and for every gauge of a name by which
/// these mean the load.
void check_gauge_names(const Deck& deck, const Node& root);

}  // namespace dda
