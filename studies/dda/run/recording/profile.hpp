#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Where the time of a run went: for each phase its seconds without the phases inside it, its calls, and,
/// where something is saved, how much of what was not done.
nlohmann::ordered_json profile_of(const Timings& timings, const Simulation& simulation);

/// The profile of a summary as a table, the phases in the order of their first call.
std::string profile_table(const nlohmann::ordered_json& summary);

}  // namespace dda
