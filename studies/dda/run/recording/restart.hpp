#pragma once

#include <filesystem>

#include "framework/files/run/restart_file.hpp"
#include "studies/dda/case/simulation.hpp"
#include "studies/dda/record/run_memory.hpp"

namespace dda {

/// Everything that the next step depends on, and what the run's files need to go on.
/// `effective` is effective_deck(deck): it is the same all through a run, and long.
RestartData restart_data(const Simulation& simulation, const RunMemory& memory, const DeckFile& deck,
                         const std::string& effective);

/// The deck of an interrupted run with further overrides; its text is that of the original.
DeckFile deck_of(const RestartData& data, const std::filesystem::path& folder,
                 const std::vector<std::string>& overrides);

/// Puts a prepared simulation where the run stood; `begin_path` is called here.
/// Throws InputError when the deck's structure has another size now.
RunMemory restore(const RestartData& data, const std::filesystem::path& folder, Simulation& simulation);

}  // namespace dda
