#include <fmt/format.h>

#include "framework/files/run/run_folder.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/figures/figure_file.hpp"
#include "studies/dda/figures/overlay.hpp"

namespace dda {
namespace {

void check_units(const std::vector<RunCurve>& runs) {
  for (const RunCurve& run : runs)
    if (!have_same_units(run, runs.front()))
      throw InputError(Position{run.name}, "its units differ from those of '" + runs.front().name + "'");
}

}  // namespace

int command_plot(const CommandLine& line) {
  require_figure_name(line.out);
  std::vector<RunCurve> runs;
  for (const std::filesystem::path& folder : line.runs) {
    require_run_folder(folder);
    runs.push_back(read_run_curve(folder));
  }
  check_units(runs);
  const std::vector<std::string> common = common_displacements(runs);
  if (common.empty())
    throw InputError(Position{line.runs.front().string()}, "the runs have no displacement gauge in common");
  svg::Figure figure;
  for (const std::string& gauge : common) figure.panels.push_back(overlay(runs, gauge));
  write_figure(line.out, svg::to_svg(figure));
  fmt::print("{}\n", line.out.string());
  return 0;
}

}  // namespace dda
