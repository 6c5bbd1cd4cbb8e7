#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "continuation/ranks/ranks.hpp"
#include "framework/files/curve_table.hpp"
#include "studies/dda/case/simulation.hpp"
#include "studies/dda/record/run_memory.hpp"

namespace dda {

/// "goal_reached", "stopped_early" or "interrupted": what summary.json and the last line call an ending.
std::string status_of(const Ending& ending);

/// Where its entry is found, for the last line; "" where it has none.
std::string what_now(const Ending& ending);

/// 0 goal_reached, 3 stopped_early, 130 interrupted.
int exit_code_of(const Ending& ending);

/// Work that neither stored nor dissipated energy nor a booked jump accounts for, relative to the largest that loads have
/// done on the way.
double energy_balance_error(const Measurement& start, const Measurement& end, double jump_energy,
                            double largest_work);

/// Step, load factor, load and gauges of the largest load.
nlohmann::ordered_json peak_of(const RunMemory& memory, const Measures& measures);

/// The events that the path has passed, with the peak of each of its stages among them (record/path/peak.hpp).
nlohmann::ordered_json events_with_peaks(const RunMemory& memory, const Measures& measures,
                                         const CsvTable& curve);

/// `newton_iterations`: of the rows of curve.csv, those of the accepted steps.
std::int64_t iterations_of(const CsvTable& curve);

/// Adds what computed a run: `version`, and `plugins` where there were any.
void add_program(nlohmann::ordered_json& summary);

/// The content of summary.json, but for the log's notices.
nlohmann::ordered_json summarise(const Simulation& simulation, const RunMemory& memory,
                                 const Measures& measures, const Ending& ending);

/// Numbers that every summary of a path has, by their dotted names; `peak.gauges.NAME` beside them.
inline constexpr std::array<std::string_view, 17> numbers_of_summaries = {
    "peak.load",       "peak.load_factor",     "peak.step",
    "steps",           "rejected_steps",       "rescues",
    "external_work",   "stored_energy",        "dissipated_energy",
    "jump_energy",     "energy_balance_error", "blocks",
    "unknowns",        "interface_points",     "crackable_points",
    "peak_memory_mib", "timings.total"};

/// MatrixQuality of the intact stiffness, `start`, and of the tangent at the last accepted state, `end`.
/// A condition beyond what can be estimated is null.
nlohmann::ordered_json stiffness_quality(const Simulation& simulation);

/// How many share the run, the memory of each, and what they have sent each other.
nlohmann::ordered_json to_json(Ranks& ranks);

/// Seconds by phase, `total` and `start_up`.
nlohmann::ordered_json to_json(const Timings& timings);

}  // namespace dda
