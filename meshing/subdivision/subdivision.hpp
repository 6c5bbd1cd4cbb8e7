#pragma once

#include "framework/deck/family.hpp"
#include "meshing/layout.hpp"

namespace dda {

/// How the regions of a scene are cut into blocks.
class Subdivision {
 public:
  virtual ~Subdivision() = default;
  /// Cells that fill the layout's regions, each of one region, in an order that depends on nothing else.
  virtual Cells divide(const Layout& layout) const = 0;
};

/// Every subdivision, for the deck key `subdivision`.
Family<Subdivision>& subdivisions();

}  // namespace dda
