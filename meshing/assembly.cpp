#include "meshing/assembly.hpp"

namespace dda {

std::vector<BlockId> blocks_at(const Assembly& assembly, const Vec2& x, double tolerance) {
  std::vector<BlockId> found;
  for (std::size_t b = 0; b < assembly.num_blocks(); ++b) {
    const Polygon& outline = assembly.blocks[b].outline;
    if (bounding_box(outline.vertices).inflated(tolerance).contains(x) && contains(outline, x, tolerance))
      found.push_back(BlockId{b});
  }
  return found;
}

}  // namespace dda
