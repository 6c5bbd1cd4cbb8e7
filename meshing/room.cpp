#include "meshing/room.hpp"

#include <fmt/format.h>

#include "framework/base/memory.hpp"
#include "meshing/geometry/geos.hpp"

namespace dda {
namespace {

/// Of a run: its mesh, joints and factor. Measured in studies/scaling where few points crack, 14 kB.
constexpr double bytes_per_block = 8000;

}  // namespace

void require_room(double blocks, const Position& where) {
  const double needed = bytes_per_block * blocks;
  if (needed <= memory_limit()) return;
  throw InputError(
      where, fmt::format("some {:.2g} blocks need {:.3g} GiB of memory or more, and there are {:.3g}; make "
                         "the blocks larger, or give `--memory-limit` to try it all the same",
                         blocks, needed / bytes_per_gib, memory_limit() / bytes_per_gib));
}

double area_of(const Layout& layout) {
  double sum = 0;
  for (const Shape& shape : layout.shapes) sum += area(shape.figure);
  return sum;
}

}  // namespace dda
