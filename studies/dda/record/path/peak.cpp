#include "studies/dda/record/path/peak.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "continuation/path/path.hpp"
#include "studies/dda/record/column_names.hpp"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

/// Share of the peak by which loads that are the same differ.
constexpr double round_off = 1e-9;

bool reaches(double load, double peak) {
  return load * std::copysign(1, peak) >= (1 - round_off) * std::abs(peak);
}

bool is_as_high(const Json& event, double peak) {
  return event["kind"] == "limit_point" && reaches(event["load"].get<double>(), peak);
}

/// The first row of the stage of a row, and the one behind its last.
std::pair<std::ptrdiff_t, std::ptrdiff_t> rows_of_stage(const CsvTable& curve, std::size_t row) {
  if (!curve.has(column::stage)) return {0, static_cast<std::ptrdiff_t>(curve.num_rows())};
  const std::vector<double> stages = curve.numbers(column::stage);
  const auto [first, last] = std::ranges::equal_range(stages, stages.at(row));
  return {first - stages.begin(), last - stages.begin()};
}

Json limit_point(const Json& peak, double dissipated) {
  return {{"kind", "limit_point"},
          {"of", "load"},
          {"extremum", peak["load"] > 0 ? "maximum" : "minimum"},
          {"located", "at_step"},
          {"uncertainty", 0.0},
          {"step", peak["step"]},
          {"load", peak["load"]},
          {"load_factor", peak["load_factor"]},
          {"dissipated_energy", dissipated},
          {"gauges", peak["gauges"]}};
}

}  // namespace

bool is_passed(const CsvTable& curve, std::size_t peak) {
  const auto [begin, end] = rows_of_stage(curve, peak);
  const auto part = [&, begin = begin, end = end](const std::string& name) {
    const std::vector<double> all = curve.numbers(name);
    return std::vector(all.begin() + begin, all.begin() + end);
  };
  const std::vector<double> loads = part(column::load), works = part(column::external_work);
  const auto at = static_cast<std::ptrdiff_t>(peak) - begin;
  const double highest = loads.at(static_cast<std::size_t>(at));
  const auto falls = [&](double load) { return !reaches(load, highest); };
  if (std::any_of(loads.begin() + at, loads.end(), falls)) return true;
  const auto first = std::ranges::find_if_not(loads, falls) - loads.begin();
  const double moved = works.back() - works[static_cast<std::size_t>(first)];
  return std::abs(moved) > turn_depth * std::abs(works.back());
}

Json with_peak(Json events, const Json& peak, const CsvTable& curve) {
  const auto step = peak["step"].get<std::size_t>();
  const auto load = peak["load"].get<double>();
  if (step == 0 || !is_passed(curve, step)) return events;
  const auto [begin, end] = rows_of_stage(curve, step);
  const auto is_of_stage = [first = begin, last = end](const Json& event) {
    const auto at = event["step"].get<std::ptrdiff_t>();
    return first <= at && at < last;
  };
  if (std::ranges::any_of(events, [&](const Json& e) { return is_of_stage(e) && is_as_high(e, load); }))
    return events;
  Json found = limit_point(peak, curve.numbers(column::dissipated_energy).at(step));
  if (curve.has(column::stage)) found["stage"] = static_cast<int>(curve.numbers(column::stage).at(step));
  const auto place = [](const Json& event) {
    return std::pair{event["step"].get<std::size_t>(), event["dissipated_energy"].get<double>()};
  };
  const auto later =
      std::ranges::find_if(events, [&](const Json& event) { return place(event) > place(found); });
  events.insert(later, found);
  return events;
}

}  // namespace dda
