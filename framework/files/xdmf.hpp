#pragma once

#include <string>
#include <vector>

#include "framework/files/results_file.hpp"

namespace dda {

/// The text of run.xdmf: a temporal collection whose steps hold the grid of blocks (Mixed polygons) and, when
/// there are any, the grid of interface segments; all numbers stay in `h5_name`, a file beside it.
/// Source: XDMF 2.2 as both readers of ParaView 5.11 take it.
std::string xdmf_text(const std::string& h5_name, const ResultsFile::Sizes& sizes,
                      const std::vector<ResultsFile::StepEntry>& steps);

/// How many rows a field on `place` has.
std::size_t num_places(const ResultsFile::Sizes& sizes, FieldPlace place);

}  // namespace dda
