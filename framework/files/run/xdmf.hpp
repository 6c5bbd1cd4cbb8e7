#pragma once

#include <string>
#include <vector>

#include "framework/files/run/results.hpp"

namespace dda {

/// What run.xdmf says about one field and one step.
struct XdmfField {
  std::string name;
  FieldPlace place;
  int components;
  std::string labels = {};  ///< of the components, "n s"; those beyond them are zero
};

/// Sizes of what cracks have cut at a step.
struct XdmfCuts {
  std::size_t parts = 0, vertices = 0, mixed = 0, whole = 0, pieces = 0;
};

struct XdmfStep {
  int step;
  double time;
  std::vector<XdmfField> fields;
  XdmfCuts cuts = {};
};

struct XdmfSizes {
  std::size_t blocks = 0, vertices = 0, mixed = 0, segments = 0;
  bool has_region = false;
};

/// The text of run.xdmf: a temporal collection whose steps hold the grid of blocks (Mixed polygons) and, when
/// there are any, the grids of interface segments, of the parts of cut blocks (which are only points among the
/// blocks) and of cracks; all numbers stay in the files of `fields/` beside it.
/// Source: XDMF 2.2 as both readers of ParaView 5.11 take it.
std::string xdmf_text(const XdmfSizes& sizes, const std::vector<XdmfStep>& steps);

/// How many rows a field on `place` has.
std::size_t num_places(const XdmfSizes& sizes, const XdmfCuts& cuts, FieldPlace place);

}  // namespace dda
