#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/figure/plot.hpp"
#include "framework/files/curve_table.hpp"

namespace dda {

/// What a run folder says about its curve.
struct RunCurve {
  std::string name;  ///< in the legend
  CsvTable curve;
  std::string length_unit, load_unit;
  std::vector<std::string> displacements;              ///< columns in units of length
  std::map<std::string, svg::Marker> references = {};  ///< peak known from elsewhere, by gauge
  std::map<int, double> starts = {};                   ///< load at which a stage begins, by its number
};

/// Named after its folder. Throws InputError when a file is missing or wrong.
RunCurve read_run_curve(const std::filesystem::path& folder);

bool have_same_units(const RunCurve& a, const RunCurve& b);

/// The displacement gauges that all of them have, in the order of the first.
std::vector<std::string> common_displacements(const std::vector<RunCurve>& runs);

/// Load against a gauge that all of them have, in the units of the first; of up to six runs solid where
/// stable under dead load, dashed where not, dotted where that is not known.
svg::Panel overlay(const std::vector<RunCurve>& runs, const std::string& gauge);

}  // namespace dda
