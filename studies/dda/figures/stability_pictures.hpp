#pragma once

#include "framework/figure/plot.hpp"
#include "framework/files/run/run_folder.hpp"
#include "studies/dda/record/fields.hpp"
#include "studies/dda/record/measures.hpp"

namespace dda {

/// A curve in pieces by its stability, each in its stability_lines. One series without a name where all of it is
/// stable. The columns are those of curve.csv.
std::vector<svg::Series> by_stability(const CsvTable& curve, const std::string& x, const std::string& y);

struct LegendEntry {
  std::string name;
  int colour = 0;
};

/// The same in one colour under one name: dashed wherever it is not stable under dead load.
std::vector<svg::Series> by_stability(const CsvTable& curve, const std::string& x, const std::string& y,
                                      const LegendEntry& entry);

/// Of a run with eigenvalues: eigenvalues.svg, μ/μ₀ of the tracked modes and the current stiffness over the
/// path; and, up to `most_blocks` blocks, modes.svg, the shapes at the stored stages (rows) and modes
/// (columns).
void write_stability_pictures(const RunFolder& folder, const Fields& fields, const Measures& measures);

}  // namespace dda
