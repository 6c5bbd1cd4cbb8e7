#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/output/svg/plot.hpp"
#include "studies/commands.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// What a run folder says about its curve.
struct ReadRun {
  std::string name;
  CsvTable curve;
  std::string length_unit, load_unit;
  std::vector<std::string> displacements;  ///< columns in units of length
};

std::string length_unit_of(const fs::path& folder) {
  const Node deck = read_yaml(folder / "effective_deck.yaml");
  const Node* units = deck.find("units");
  const Node* length = units ? units->find("length") : nullptr;
  return length ? length->text : Units{}.length;
}

ReadRun read_run(const fs::path& folder) {
  const fs::path file = folder / "curve.units.json";
  const auto units = nlohmann::ordered_json::parse(read_whole(file), nullptr, false);
  if (!units.is_object()) throw InputError(Position{file.string()}, "is not a list of units");
  ReadRun out{(folder / "").lexically_normal().parent_path().filename().string(),
              read_csv(folder / "curve.csv"),
              length_unit_of(folder),
              units.value("load", ""),
              {}};
  for (const std::string& column : out.curve.names())
    if (units.value(column, "") == out.length_unit) out.displacements.push_back(column);
  return out;
}

std::vector<std::string> common_displacements(const std::vector<ReadRun>& runs) {
  std::vector<std::string> out = runs.front().displacements;
  for (const ReadRun& run : runs)
    std::erase_if(out, [&](const std::string& name) {
      return std::ranges::find(run.displacements, name) == run.displacements.end();
    });
  return out;
}

void check_units(const std::vector<ReadRun>& runs) {
  for (const ReadRun& run : runs)
    if (run.length_unit != runs.front().length_unit || run.load_unit != runs.front().load_unit)
      throw InputError(Position{run.name}, "its units differ from those of '" + runs.front().name + "'");
}

svg::Panel panel(const std::vector<ReadRun>& runs, const std::string& gauge) {
  const ReadRun& first = runs.front();
  svg::Panel out{.title = gauge,
                 .x_label = fmt::format("{} [{}]", gauge, first.length_unit),
                 .y_label = first.load_unit.empty() ? "load" : fmt::format("load [{}]", first.load_unit),
                 .series = {},
                 .markers = {}};
  for (const ReadRun& run : runs)
    out.series.push_back({run.name, run.curve.numbers(gauge), run.curve.numbers("load")});
  return out;
}

}  // namespace

int command_plot(const CommandLine& line) {
  std::vector<ReadRun> runs;
  for (const fs::path& folder : line.runs) runs.push_back(read_run(RunFolder::open(folder).path()));
  check_units(runs);
  const std::vector<std::string> common = common_displacements(runs);
  if (common.empty())
    throw InputError(Position{line.runs.front().string()}, "the runs have no displacement gauge in common");
  svg::Figure figure;
  for (const std::string& gauge : common) figure.panels.push_back(panel(runs, gauge));
  write_whole(line.out, svg::to_svg(figure), Flush::to_system);
  fmt::print("{}\n", line.out.string());
  return 0;
}

}  // namespace dda
