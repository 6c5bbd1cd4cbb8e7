#pragma once

#include <compare>
#include <map>
#include <optional>

#include "models/interface_point.hpp"

namespace dda {

/// A side of an interface, or a piece of one along which a crack runs.
struct SideKey {
  int interface = -1;
  std::size_t side = 0;
  std::optional<std::size_t> cut = {};

  explicit SideKey(const InterfacePoint& point)
      : interface(point.interface), side(point.side), cut(point.cut) {}
  auto operator<=>(const SideKey&) const = default;
};

/// Where what closes on a side turns: about the outermost of its points.
struct TurningPlace {
  std::size_t num_points = 0;
  double length = 0;             ///< of the side [L]
  double inside = 0;             ///< of its length, from its corner to that point
  bool is_second_order = false;  ///< a block beside it is

  /// Of the load that turns about its corner.
  double carried() const { return 1 - 2 * inside; }
  /// What has it turn there.
  const char* remedy() const {
    return is_second_order
               ? "blocks of first order on both sides of it, which may have `points: vertices`, turn "
                 "about their corners, and more sides on it come closer"
               : "`points: vertices` has bodies turn about their corners";
  }
};

/// Of all sides with several points that can crack, and none at their ends.
std::map<SideKey, TurningPlace> turning_places(const InterfaceSet& set, double thickness);

}  // namespace dda
