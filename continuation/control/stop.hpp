#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace dda {

/// Why a run stops early. Each has an entry of its name in docs/stopped.md, which `dda explain NAME` prints.
enum class Stop {
  limit_point,
  snap_back,
  gauge_stands,
  nothing_dissipates,
  release_held,
  increments_failed,
  no_further_crack,
  dynamic,
  limit_of_steps,
  standstill,
  mechanism,
  no_next_equilibrium,
  next_initiation,
  unloading,
  turned_round,
  stages_left,
  singular,
  weak_springs,
  energies,
  beyond_strength,
  out_of_range,
  dead_load,
  crack_stuck,
  crack_grown,
  not_at_rest,
  no_step,
  overlap
};

inline constexpr std::array<std::pair<Stop, const char*>, 27> names_of_stops = {{
    {Stop::limit_point, "limit-point"},
    {Stop::snap_back, "snap-back"},
    {Stop::gauge_stands, "gauge-stands"},
    {Stop::nothing_dissipates, "nothing-dissipates"},
    {Stop::release_held, "release-held"},
    {Stop::increments_failed, "increments-failed"},
    {Stop::no_further_crack, "no-further-crack"},
    {Stop::dynamic, "dynamic"},
    {Stop::limit_of_steps, "limit-of-steps"},
    {Stop::standstill, "standstill"},
    {Stop::mechanism, "mechanism"},
    {Stop::no_next_equilibrium, "no-next-equilibrium"},
    {Stop::next_initiation, "next-initiation"},
    {Stop::unloading, "unloading"},
    {Stop::turned_round, "turned-round"},
    {Stop::stages_left, "stages-left"},
    {Stop::singular, "singular"},
    {Stop::weak_springs, "weak-springs"},
    {Stop::energies, "energies"},
    {Stop::beyond_strength, "beyond-strength"},
    {Stop::out_of_range, "out-of-range"},
    {Stop::dead_load, "dead-load"},
    {Stop::crack_stuck, "crack-stuck"},
    {Stop::crack_grown, "crack-grown"},
    {Stop::not_at_rest, "not-at-rest"},
    {Stop::no_step, "no-step"},
    {Stop::overlap, "overlap"},
}};

inline std::string to_string(Stop stop) {
  for (const auto& [value, name] : names_of_stops)
    if (value == stop) return name;
  return {};
}

/// One of them, and what it says of this run.
struct Stopped {
  Stop stop;
  std::string text;
};

}  // namespace dda
