#include "studies/dda/sweep/sweep_figure.hpp"

#include <algorithm>

#include "framework/files/whole_file.hpp"
#include "studies/dda/figures/overlay.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_legend = 8;  ///< the palette has as many colours

/// Cases of one legend entry share its colour.
class Legend {
 public:
  explicit Legend(const Sweep& sweep) : sweep_(sweep) {
    for (const Axis& axis : sweep.axes) {
      if (axis.size() > 1) {
        has_axis_ = axis.size() <= longest_legend;
        return;
      }
      key_ += axis.keys.size();
    }
  }
  std::string entry(std::size_t index) const {
    const SweepCase& one = sweep_.cases[index];
    if (sweep_.cases.size() <= longest_legend) return settings_text(sweep_, one);
    return has_axis_ ? setting_text(sweep_, one, key_) : "";
  }

 private:
  const Sweep& sweep_;
  std::size_t key_ = 0;  ///< the first one that varies
  bool has_axis_ = false;
};

}  // namespace

void write_sweep_figure(const Sweep& sweep, const fs::path& folder, const std::vector<CaseState>& states) {
  const Legend legend(sweep);
  std::vector<RunCurve> runs;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!states[i].has_result()) continue;
    runs.push_back(read_run_curve(folder / case_folder(sweep, i)));
    runs.back().name = legend.entry(i);
  }
  fs::remove(folder / "curves.svg");  // of an earlier sweep
  if (runs.empty()) return;
  const auto like_first = [&](const RunCurve& run) { return have_same_units(run, runs.front()); };
  const std::vector<std::string> common = common_displacements(runs);
  if (common.empty() || !std::ranges::all_of(runs, like_first)) return;
  const svg::Figure figure{.title = sweep.title, .panels = {overlay(runs, common.front())}};
  write_shared(folder / "curves.svg", svg::to_svg(figure));
}

}  // namespace dda
