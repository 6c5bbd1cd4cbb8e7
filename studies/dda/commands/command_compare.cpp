#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "continuation/control/control.hpp"
#include "framework/base/suggestion.hpp"
#include "framework/figure/plot.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/tell.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/commands/path_distance.hpp"
#include "studies/dda/figures/figure_file.hpp"
#include "studies/dda/run/recording/summary.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

struct Compared {
  std::string control;
  RunResult result;
  double seconds = 0;
  PathDistance distance;   ///< to the first control's path
  double at_landings = 0;  ///< difference of load on the wanted gauge values, nothing interpolated
  bool is_expected = false;
};

void require_known(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const FamilyMember* member : controls().entries()) known.push_back(member->name);
  Findings findings;
  for (const std::string& name : names)
    if (!controls().find(name))
      findings.add(Position{"--controls"}, fmt::format("unknown control '{}'{}", name, suggest(name, known)));
  findings.throw_if_any();
}

/// One deck per control; a control that the deck describes keeps its parameters.
std::vector<DeckFile> decks_of(const CommandLine& line) {
  require_known(line.controls);
  const DeckFile given = read_deck(line.deck, line.overrides);
  std::vector<DeckFile> out;
  for (const std::string& control : line.controls) {
    std::vector<std::string> overrides = line.overrides;
    if (control != given.deck.path.control.name()) overrides.push_back("path.control=" + control);
    out.push_back(read_deck(line.deck, overrides));
  }
  return out;
}

/// What is wrong with any of the controls is found before the first one runs.
void check_controls(const std::vector<DeckFile>& decks) {
  Timings timings;
  const Simulation simulation(decks.front().deck, timings);
  Findings findings;
  for (const DeckFile& deck : decks) {
    try {
      deck.deck.path.control.make(simulation.gauges());
    } catch (const InputError& error) {
      findings.add(error);
    }
  }
  findings.throw_if_any();
}

RunFolder folder_of(const CommandLine& line) {
  if (!line.run.folder.empty())
    return RunFolder::create(line.run.folder, line.run.overwrite ? IfExists::overwrite : IfExists::refuse);
  const fs::path wanted = default_run_folder(line.deck).string() + "-compare";
  return RunFolder::create(wanted, line.run.overwrite ? IfExists::overwrite : IfExists::number);
}

Compared run_control(const DeckFile& deck, const std::string& control, const fs::path& folder,
                     const CommandLine& line) {
  if (!line.run.quiet) tell(stderr, "{}\n", control);
  const auto start = std::chrono::steady_clock::now();
  const RunOptions options{folder / control, line.run.overwrite, line.run.quiet};
  Compared out{control, run_deck(deck, options), 0, {}, 0, false};
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto& expected = deck.deck.path.expected_to_stop;
  out.is_expected = out.result.ending.kind == Ending::Kind::goal_reached ||
                    (out.result.ending.kind == Ending::Kind::stopped_early &&
                     std::ranges::find(expected, control) != expected.end());
  return out;
}

std::vector<Column> columns(const Compared& first) {
  return {{"control", ""},
          {"status", ""},
          {"reason", ""},
          {"steps", ""},
          {"rejected", ""},
          {"rescues", ""},
          {"iterations", ""},
          {"factorisations", ""},
          {"seconds", "s"},
          {"peak", first.result.measures.load_unit()},
          {"load_difference", ""},
          {"hausdorff_distance", ""},
          {"difference_at_landings", ""}};
}

std::vector<TableCell> row(const Compared& run) {
  const auto& s = run.result.summary;
  const auto count = [&](const char* name) { return s[name].get<std::int64_t>(); };
  return {run.control,
          status_of(run.result.ending),
          run.result.ending.reason,
          count("steps"),
          count("rejected_steps"),
          count("rescues"),
          count("whole_iterations") + count("reduced_iterations"),
          count("factorisations"),
          run.seconds,
          s["peak"]["load"].get<double>(),
          run.distance.load,
          run.distance.hausdorff,
          run.at_landings};
}

std::string text_of(const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.5g}", *number);
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *count);
  return std::get<std::string>(cell);
}

/// A Markdown table with aligned columns.
std::string table(const std::vector<Compared>& runs) {
  std::vector<std::vector<std::string>> rows(1);
  for (const Column& column : columns(runs.front())) rows[0].push_back(column.name);
  for (const Compared& run : runs) {
    rows.emplace_back();
    for (const TableCell& cell : row(run)) rows.back().push_back(text_of(cell));
  }
  std::vector<std::size_t> widths(rows[0].size());
  for (const auto& texts : rows)
    for (std::size_t c = 0; c < texts.size(); ++c) widths[c] = std::max(widths[c], texts[c].size());
  std::string out;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < widths.size(); ++c) out += fmt::format("| {:<{}} ", rows[r][c], widths[c]);
    out += "|\n";
    if (r > 0) continue;
    for (const std::size_t width : widths) out += "|" + std::string(width + 2, '-');
    out += "|\n";
  }
  return out;
}

svg::Figure overlay(const std::vector<Compared>& runs) {
  const Measures& measures = runs.front().result.measures;
  svg::Figure out;
  for (std::size_t k = 0; k < measures.displacements().size(); ++k) {
    const Column& column = measures.names()[measures.displacements()[k]];
    svg::Panel panel{.title = column.name,
                     .x_label = fmt::format("{} [{}]", column.name, column.unit),
                     .y_label = fmt::format("load [{}]", measures.load_unit())};
    for (std::size_t r = 0; r < runs.size(); ++r) {
      svg::Series series{.name = runs[r].control, .dashed = r > 0};
      for (const TracePoint& point : runs[r].result.trace) {
        series.x.push_back(point.displacements[k]);
        series.y.push_back(point.load);
      }
      if (runs[r].result.ending.kind == Ending::Kind::stopped_early && !series.x.empty())
        panel.markers.push_back({series.x.back(), series.y.back(), runs[r].control + " stops"});
      panel.series.push_back(std::move(series));
    }
    out.panels.push_back(std::move(panel));
  }
  return out;
}

/// Over the displacement gauges on whose values the deck lets steps land.
double at_landings(const Deck& deck, const RunResult& first, const RunResult& second) {
  const Measures& measures = first.measures;
  double largest = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < measures.displacements().size(); ++k) {
    const auto wanted = deck.record.at.find(measures.names()[measures.displacements()[k]].name);
    if (wanted != deck.record.at.end())
      largest = std::fmax(largest, difference_at(first.trace, second.trace, k, wanted->second));
  }
  return largest;
}

void write_comparison(const RunFolder& folder, const std::vector<Compared>& runs, const fs::path& figure) {
  CurveTable csv(folder.file("compare.csv"), columns(runs.front()));
  for (const Compared& run : runs) csv.append(row(run));
  write_whole(folder.file("compare.md"), table(runs), Flush::to_system);
  if (runs.front().result.measures.displacements().empty()) {
    if (!figure.empty())
      throw OutputError(
          fmt::format("{}: nothing to draw: the deck has no gauge of a displacement", figure.string()));
    return;
  }
  const std::string svg = svg::to_svg(overlay(runs));
  write_whole(folder.file("compare.svg"), svg, Flush::to_system);
  if (!figure.empty()) write_figure(figure, svg);
}

}  // namespace

int command_compare(const CommandLine& line) {
  if (!line.picture.empty()) require_figure_name(line.picture);
  const std::vector<DeckFile> decks = decks_of(line);
  check_controls(decks);
  const RunFolder folder = folder_of(line);
  std::vector<Compared> runs;
  for (std::size_t i = 0; i < decks.size(); ++i) {
    runs.push_back(run_control(decks[i], line.controls[i], folder.path(), line));
    if (runs.back().result.ending.kind == Ending::Kind::interrupted) return 130;
    runs.back().distance = distance(runs.front().result.trace, runs.back().result.trace);
    runs.back().at_landings = at_landings(decks[i].deck, runs.front().result, runs.back().result);
  }
  write_comparison(folder, runs, line.picture);
  fmt::print("{}{}\n", table(runs), folder.path().string());
  return std::ranges::all_of(runs, &Compared::is_expected) ? 0 : 3;
}

}  // namespace dda
