#pragma once

#include <map>

#include "framework/figure/plot.hpp"
#include "framework/files/run/run_folder.hpp"
#include "studies/dda/record/fields.hpp"
#include "studies/dda/record/measures.hpp"

namespace dda {

/// Load at which a stage begins, by its number: the curve has no row there.
using StageStarts = std::map<int, double>;

/// The table of curve.csv. A stage without a start begins at load 0.
struct StagedCurve {
  const CsvTable& table;
  StageStarts starts = {};
};

/// A curve in pieces by its stability, each in its stability_lines. One series without a name where all of it is
/// stable. The columns are those of curve.csv.
std::vector<svg::Series> by_stability(const StagedCurve& curve, const std::string& x, const std::string& y);

struct LegendEntry {
  std::string name;
  int colour = 0;
};

/// The same in one colour under one name: dashed wherever it is not stable under dead load.
std::vector<svg::Series> by_stability(const StagedCurve& curve, const std::string& x, const std::string& y,
                                      const LegendEntry& entry);

/// The same as one series, whatever its stability.
svg::Series whole(const StagedCurve& curve, const std::string& x, const std::string& y);

/// Of a run with eigenvalues: eigenvalues.svg, μ/μ₀ of the tracked modes and the current stiffness over the
/// path; and, up to `most_blocks` blocks, modes.svg, the shapes at the stored stages (rows) and modes
/// (columns).
void write_stability_pictures(const RunFolder& folder, const Fields& fields, const Measures& measures);

}  // namespace dda
