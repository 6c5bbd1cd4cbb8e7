#include "studies/dda/sweep/launch/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/messages/tell.hpp"
#include "studies/dda/case/predicted_memory.hpp"
#include "studies/dda/sweep/sweep_progress.hpp"

namespace dda {
namespace {

constexpr double bytes_per_mib = 1024.0 * 1024.0;
constexpr std::size_t most_meshed = 8;
constexpr double cracks_take = 1.5;       ///< times what the intact structure takes
constexpr double others_may_take = 1.25;  ///< times the most that any case took
constexpr double of_the_sweep = 64;       ///< the process that starts the runs, and its keepers [MiB]
constexpr double time_reserve = 2;        ///< times the longest case
constexpr double shortest_time = 300;     ///< [s]

/// Evenly spread ones, first and last among them.
std::vector<std::size_t> some_of(const std::vector<std::size_t>& all) {
  if (all.size() <= most_meshed) return all;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < most_meshed; ++i) out.push_back(all[i * (all.size() - 1) / (most_meshed - 1)]);
  return out;
}

std::string name_of_case(const Sweep& sweep, std::size_t index) {
  return case_folder(sweep, index).filename().string();
}

/// [MiB]; 0 when it cannot be meshed.
double least_memory_of(const Sweep& sweep, std::size_t index) {
  try {
    const DeckFile file = read_deck(sweep.cases[index].deck, sweep.cases[index].overrides);
    Timings timings;
    return predicted_memory(Simulation(file.deck, timings)).total() / bytes_per_mib;
  } catch (const InputError& error) {
    tell(stderr, "case {} will fail: {}\n", name_of_case(sweep, index), error.what());
    return 0;
  }
}

void look_at_open(const Sweep& sweep, const std::vector<std::size_t>& open, Forecast& out) {
  out.memory_text = "no case is left";
  if (open.empty()) return;
  const std::vector<std::size_t> some = some_of(open);
  std::size_t largest = some.front();
  for (const std::size_t i : some) {
    const double memory = least_memory_of(sweep, i);
    if (memory > out.least_memory) largest = i;
    out.least_memory = std::max(out.least_memory, memory);
  }
  out.memory_text = out.least_memory > 0
                        ? fmt::format(
                              "case {} takes at least {:.0f} MiB by `dda check`, the most of {} that were "
                              "meshed",
                              name_of_case(sweep, largest), out.least_memory, some.size())
                        : "unknown, no case could be meshed";
}

void look_at_finished(const std::vector<CaseState>& states, Forecast& out) {
  std::size_t count = 0;
  for (const CaseState& state : states) {
    if (!state.has_result() || !state.summary.is_object()) continue;
    ++count;
    out.peak_memory = std::max(out.peak_memory, state.summary.value("peak_memory_mib", 0.0));
    const Json timings = state.summary.value("timings", Json::object());
    if (timings.is_object()) out.longest = std::max(out.longest, timings.value("total", 0.0));
  }
  if (out.peak_memory > 0)
    out.memory_text += fmt::format("; finished ones took up to {:.0f} MiB", out.peak_memory);
  out.time_text = out.longest > 0 ? fmt::format("the longest of {} finished cases took {}", count,
                                                duration_text(out.longest))
                                  : "unknown, no case has finished";
}

}  // namespace

double Forecast::memory_to_ask() const {
  const double wanted = std::max(cracks_take * least_memory, others_may_take * peak_memory);
  return wanted > 0 ? std::ceil(wanted + of_the_sweep) : 0;
}

double Forecast::time_to_ask(std::size_t cases_of_task) const {
  if (longest <= 0) return 0;
  return std::max(shortest_time, time_reserve * longest * static_cast<double>(cases_of_task));
}

Forecast forecast_of(const Sweep& sweep, const std::vector<CaseState>& states) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (!states[i].has_result()) open.push_back(i);
  Forecast out{.num_cases = states.size(), .num_open = open.size()};
  look_at_open(sweep, open, out);
  look_at_finished(states, out);
  return out;
}

}  // namespace dda
