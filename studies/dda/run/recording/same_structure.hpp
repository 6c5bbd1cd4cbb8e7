#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/files/run/restart_file.hpp"
#include "models/equilibrium/equilibrium.hpp"
#include "studies/dda/case/deck/deck.hpp"

namespace dda {

/// Throws InputError, with the first such key, where the deck of a run that goes on says something else than its effective deck
/// before of the structure, of loads that have acted, or of what the columns of its curve are. Controls, goals, records and the
/// motion behind the path may be others, and stages may follow.
void require_same_structure(const std::string& before, const Deck& now, const std::filesystem::path& folder);

/// What each law of a structure remembers, as the law declares it.
std::vector<std::string> remembered(const Equilibrium& equilibrium);

/// Throws InputError where a restart is of other blocks, points or laws than there are.
void require_same_points(const RestartData& data, const std::filesystem::path& folder,
                         const Equilibrium& equilibrium);

}  // namespace dda
