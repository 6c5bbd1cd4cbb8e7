#pragma once

#include <string>
#include <utility>

#include "framework/base/errors.hpp"
#include "framework/base/vec2.hpp"

namespace dda {

/// A place that the deck points at: its coordinates, or the name of one of the scene's points, which are
/// known once the scene has been read.
struct Spot {
  Vec2 x = Vec2::Zero();  ///< [L]; of no use where there is a name
  std::string name;
  Position where;

  Spot() = default;
  Spot(Vec2 place) : x(std::move(place)) {}
  Spot(double x_, double y_) : x(x_, y_) {}
  bool operator==(const Spot& other) const { return x == other.x && name == other.name; }
};

}  // namespace dda
