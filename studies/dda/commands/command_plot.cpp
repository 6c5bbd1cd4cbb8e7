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

/// The curves of runs over one another, by each gauge that they have in common.
std::string overlaid(const CommandLine& line) {
  std::vector<RunCurve> runs;
  for (const std::filesystem::path& folder : line.runs) {
    runs.push_back(read_run_curve(folder));
  }
  check_units(runs);
  const std::vector<std::string> common = common_displacements(runs);
  if (common.empty())
    throw InputError(Position{line.runs.front().string()}, "the runs have no displacement gauge in common");
  svg::Figure figure;
  for (const std::string& gauge : common) {
    svg::Panel& panel = figure.panels.emplace_back(overlay(runs, gauge));
    panel.is_logarithmic_x = line.logarithmic.starts_with('x');
    panel.is_logarithmic_y = line.logarithmic.ends_with('y');
  }
  return svg::to_svg(figure);
}

/// A figure that a run has made.
std::string figure_of(const CommandLine& line) {
  if (line.runs.size() > 1)
    throw InputError(Position{line.runs[1].string()},
                     "--figure is of one run; without it the curves of all are drawn over one another");
  return run_figure(line.runs.front(), line.figure);
}

}  // namespace

int command_plot(const CommandLine& line) {
  require_figure_name(line.out);
  for (const std::filesystem::path& folder : line.runs) require_run_folder(folder);
  write_figure(line.out, line.figure.empty() ? overlaid(line) : figure_of(line));
  fmt::print("{}\n", line.out.string());
  return 0;
}

}  // namespace dda
