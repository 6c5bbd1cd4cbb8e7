#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "framework/files/curve_table.hpp"

namespace dda {

/// What the columns of a curve say of an equilibrium's stability.
enum class Stability {
  stable,         ///< under dead load
  under_control,  ///< only while the control holds what it prescribes
  unstable,
  unknown  ///< the negative eigenvalues were not counted, or could not be
};

/// Of every row of curve.csv.
std::vector<Stability> stability_of(const CsvTable& curve);

/// Of the parts of a curve between its rows: the better of both ends, because at a kink the point already
/// counts as what follows; unknown where either is.
std::vector<Stability> between(const std::vector<Stability>& rows);

/// Rows by stability; of the stable ones those where the second-order work of every motion is positive.
nlohmann::ordered_json stability_counts(const CsvTable& curve);

}  // namespace dda
