#include "models/body/rotation.hpp"

#include "models/body/motion.hpp"

namespace dda {

Functional rotation_at(const Body& body, const Place& place, const Position& where) {
  if (place.over) return rotation_over(body, place, where);
  Functional out;
  const Vec2 at = locate(body.assembly, *place.at);
  const auto blocks = blocks_of(body.assembly, place, where);
  for (const BlockId id : blocks)
    for (const auto& [node, row] : rotations_at(body, id, at))
      out.rows.emplace_back(node, row / static_cast<double>(blocks.size()));
  return out;
}

}  // namespace dda
