#pragma once

#include <map>
#include <string>
#include <vector>

#include "framework/files/run/results.hpp"

namespace dda {

/// What run.xdmf says about one field and one step.
struct XdmfField {
  std::string name;
  FieldPlace place;
  int components;
  std::string labels = {};  ///< of the components; of which there are views, see results.hpp
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
  std::map<std::string, double> numbers = {};  ///< by name, such as load_factor
};

struct XdmfSizes {
  std::size_t blocks = 0, vertices = 0, mixed = 0, segments = 0;
  bool has_region = false;
  std::vector<std::string> regions = {};  ///< their names, by number
};

/// The text of run.xdmf: a temporal collection whose steps hold the grid of blocks (Mixed polygons) and, when
/// there are any, the grids of interface segments, of the parts of cut blocks (which are only points among the
/// blocks) and of cracks; all arrays stay in the files of `fields/` beside it. The numbers of a step are field data of the
/// blocks, as are, since neither reader takes texts, the numbers of the regions under their names, "region 0: concrete".
/// Source: XDMF 2.2 as both readers of ParaView 5.11 take it: Xdmf2 and Xdmf3, which takes no HyperSlab and no Function, and
/// takes the six numbers of a Tensor6 in another order; of a Tensor both take nine.
std::string xdmf_text(const XdmfSizes& sizes, const std::vector<XdmfStep>& steps);

/// How many rows a field on `place` has.
std::size_t num_places(const XdmfSizes& sizes, const XdmfCuts& cuts, FieldPlace place);

}  // namespace dda
