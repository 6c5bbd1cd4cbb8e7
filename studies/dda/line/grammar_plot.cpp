#include "studies/dda/figures/figure_file.hpp"
#include "studies/dda/line/grammar.hpp"

namespace dda {

void Grammar::add_plot() {
  CLI::App* plot = add(
      "plot", "Overlay the load-displacement curves of runs, or save a figure of a run as an image or PDF",
      command_plot);
  add_runs(plot);
  take_one_of(plot->add_option("--figure", line_.figure,
                               "Instead of curves a figure that the one run has: its deformed blocks, its "
                               "modes, the end of its motion ..."),
              names_of_run_figures());
  take_one_of(plot->add_option("--log", line_.logarithmic,
                               "Axes of the curves that are logarithmic; what is not positive is left out"),
              {"x", "y", "xy"});
  plot->add_option("--out", line_.out, "The figure: .svg, .png or .pdf")
      ->capture_default_str()
      ->type_name("FILE");
}

}  // namespace dda
