#include "studies/dda/figures/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "framework/deck/document/node.hpp"
#include "framework/deck/units.hpp"
#include "framework/figure/style.hpp"
#include "framework/files/whole_file.hpp"
#include "studies/dda/figures/stability_pictures.hpp"
#include "studies/dda/record/column_names.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string length_unit_of(const fs::path& folder) {
  const Node deck = read_yaml(folder / "effective_deck.yaml");
  const Node* units = deck.find("units");
  const Node* length = units ? units->find("length") : nullptr;
  return length ? length->text : Units{}.length;
}

/// Null of an unfinished run, which has none.
Json summary_of(const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder / "summary.json", none)) return {};
  return Json::parse(read_whole(folder / "summary.json"), nullptr, false);
}

std::map<std::string, svg::Marker> references_of(const Json& summary) {
  if (!summary.is_object() || !summary.contains("reference_peak")) return {};
  const auto& reference = summary["reference_peak"];
  std::map<std::string, svg::Marker> out;
  for (const auto& [gauge, value] : reference["at"].items())
    out[gauge] = {value.get<double>(), reference["load"].get<double>(), reference["text"].get<std::string>()};
  return out;
}

StageStarts starts_of(const Json& summary) {
  if (!summary.is_object() || !summary.contains("stages")) return {};
  StageStarts out;
  for (const Json& stage : summary["stages"]) out[stage.value("number", 0)] = stage.value("start_load", 0.0);
  return out;
}

/// Marks the peaks known from elsewhere, each once.
void mark_references(const std::vector<RunCurve>& runs, const std::string& gauge, svg::Panel& panel) {
  for (const RunCurve& run : runs) {
    const auto found = run.references.find(gauge);
    if (found == run.references.end()) continue;
    const svg::Marker& marker = found->second;
    const auto is_same = [&](const svg::Marker& m) { return m.x == marker.x && m.y == marker.y; };
    if (std::ranges::none_of(panel.markers, is_same)) panel.markers.push_back(marker);
  }
}

/// What dashes and dots mean, of those that the curves have.
std::vector<svg::Series> legend_of_lines(const std::vector<svg::Series>& curves) {
  std::vector<svg::Series> out;
  if (std::ranges::any_of(curves, &svg::Series::dashed))
    out.push_back({.name = "not stable under dead load", .dashed = true, .colour = svg::black});
  if (std::ranges::any_of(curves, &svg::Series::dotted))
    out.push_back({.name = "stability not known", .colour = svg::black, .dotted = true});
  return out;
}

/// By stability as long as there is a colour for each: beyond that dashes tell the runs apart.
std::vector<svg::Series> curves_of(const std::vector<RunCurve>& runs, const std::string& gauge) {
  constexpr std::size_t most_colours = svg::black;  // black is for the legend of the lines
  std::vector<svg::Series> out;
  std::vector<std::string> names;  // in the order of their colours
  for (const RunCurve& run : runs)
    if (run.name.empty() || std::ranges::find(names, run.name) == names.end()) names.push_back(run.name);
  std::size_t next = 0;
  for (const RunCurve& run : runs) {
    if (names.size() > most_colours) {
      out.push_back(whole({run.curve, run.starts}, gauge, column::load));
      out.back().name = run.name;
      continue;
    }
    const auto known = std::ranges::find(names, run.name) - names.begin();
    const int colour = static_cast<int>(run.name.empty() ? static_cast<std::ptrdiff_t>(next) : known);
    std::ranges::move(by_stability({run.curve, run.starts}, gauge, column::load, {run.name, colour}),
                      std::back_inserter(out));
    ++next;
  }
  std::ranges::move(legend_of_lines(out), std::back_inserter(out));
  return out;
}

}  // namespace

RunCurve read_run_curve(const fs::path& folder) {
  const fs::path file = folder / "curve.units.json";
  const auto units = nlohmann::ordered_json::parse(read_whole(file), nullptr, false);
  if (!units.is_object()) throw InputError(Position{file.string()}, "is not a list of units");
  const Json summary = summary_of(folder);
  RunCurve out{(folder / "").lexically_normal().parent_path().filename().string(),
               read_csv(folder / "curve.csv"),
               length_unit_of(folder),
               units.value(column::load, ""),
               {},
               references_of(summary),
               starts_of(summary)};
  for (const std::string& column : out.curve.names())
    if (units.value(column, "") == out.length_unit) out.displacements.push_back(column);
  return out;
}

bool have_same_units(const RunCurve& a, const RunCurve& b) {
  return a.length_unit == b.length_unit && a.load_unit == b.load_unit;
}

std::vector<std::string> common_displacements(const std::vector<RunCurve>& runs) {
  std::vector<std::string> out = runs.front().displacements;
  for (const RunCurve& run : runs)
    std::erase_if(out, [&](const std::string& name) {
      return std::ranges::find(run.displacements, name) == run.displacements.end();
    });
  return out;
}

svg::Panel overlay(const std::vector<RunCurve>& runs, const std::string& gauge) {
  const RunCurve& first = runs.front();
  svg::Panel out{.title = gauge,
                 .x_label = fmt::format("{} [{}]", gauge, first.length_unit),
                 .y_label = first.load_unit.empty() ? "load" : fmt::format("load [{}]", first.load_unit)};
  out.series = curves_of(runs, gauge);
  mark_references(runs, gauge, out);
  return out;
}

}  // namespace dda
