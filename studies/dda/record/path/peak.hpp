#pragma once

#include <nlohmann/json.hpp>

#include "framework/files/curve_table.hpp"

namespace dda {

/// Whether the path went on from the row `peak` of the curve, its highest load of a stage: the load has fallen below it,
/// or has stayed while the structure moved, before the next stage.
bool is_passed(const CsvTable& curve, std::size_t peak);

/// The located events of a path with its peak among them.
///
/// PathEvents locates limit points on continuous paths. One that goes on from its peak by a jump, a release
/// say, or as a mechanism under the same load, has none there: then the row of the peak is listed as one, as
/// soon as it is passed. Rows before other releases are not, of which each block may have one. `peak` has the
/// keys of summary.json, the curve those of curve.csv, whose row n is step n.
nlohmann::ordered_json with_peak(nlohmann::ordered_json events, const nlohmann::ordered_json& peak,
                                 const CsvTable& curve);

}  // namespace dda
