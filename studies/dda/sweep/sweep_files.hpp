#pragma once

#include <filesystem>
#include <vector>

#include "studies/dda/sweep/sweep_folder.hpp"

namespace dda {

/// What sweep.json says: the sweep, its axes, and every case with its settings and how far it is.
Json sweep_json(const Sweep& sweep, const std::string& name, const std::vector<CaseState>& states);

/// sweep.csv and its units: a row per case with `case`, `folder`, the varied keys, `status`, `exit_code`,
/// `reason`, and every number and text of its summary.json ("peak.load"), blank where a case has none.
struct SweepTable {
  std::string csv;
  Json units;  ///< of every column, "" = none or not the same in all cases
};
SweepTable sweep_table(const Sweep& sweep, const std::vector<CaseState>& states);

/// Writes sweep.json, sweep.csv and sweep.units.json, each whole or not at all.
void write_sweep_files(const Sweep& sweep, const std::filesystem::path& folder,
                       const std::vector<CaseState>& states);

}  // namespace dda
