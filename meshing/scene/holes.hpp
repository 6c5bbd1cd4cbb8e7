#pragma once

#include <string>
#include <vector>

#include "meshing/layout.hpp"

namespace dda {

/// A named polygon where nothing is.
struct Hole {
  std::string name;
  Polygon outline;
  Position where;
};

/// Takes holes away from the shapes of a sound layout, whichever they lie in or cross; the outline of each becomes a boundary of its
/// name. A shape may come out in several pieces, or with holes. Reports holes that are no simple polygons, that overlap, that lie in
/// no region, or whose name a boundary has.
void cut_holes(const std::vector<Hole>& holes, Layout& layout, Findings& findings);

}  // namespace dda
