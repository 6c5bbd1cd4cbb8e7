#pragma once

#include "framework/files/run/run_folder.hpp"
#include "studies/dda/case/deck/deck.hpp"
#include "studies/dda/run/run.hpp"

namespace dda {

/// Which folder a new run gets. A folder that the user named and that holds something is the user's to decide about.
RunFolder new_folder(const DeckFile& deck, const RunOptions& options);

/// The deck as it is, as it was read (`effective`), and as a parameter list.
void write_decks(const RunFolder& folder, const DeckFile& deck, const std::string& effective);

}  // namespace dda
