#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "framework/deck/family.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// The end of a crack, and what lies around it.
struct CrackTip {
  Vec2 at;
  Vec2 direction;         ///< of its last segment, a unit vector
  bool has_grown = true;  ///< else there is no such segment, and the direction is that in which it was begun
  double strength = 0;    ///< of the law in tension [F/L²]
  double block_size = 0;  ///< √(median area of the blocks) [L]
  double characteristic_length = 0;  ///< l_ch = E/(2 × steepest slope), E Gf/ft² of linear softening [L]
  /// (σx, σy, τxy) at a point; nothing outside of the body [F/L²].
  std::function<std::optional<Vec3>(const Vec2&)> stress;
  /// Energy that a straight way of a length would release if it bore no tension, loads and damage as they are [FL];
  /// nothing where it cannot be cut.
  std::function<std::optional<double>(const Vec2& way, double length)> released;
};

/// Which way a crack goes on when the first point ahead of it has reached its strength. When that is, is none of its
/// business.
class CrackDirection {
 public:
  virtual ~CrackDirection() = default;
  /// A unit vector.
  virtual Vec2 aim(const CrackTip& tip) const = 0;
};

using CrackDirectionFamily = Family<CrackDirection>;
using CrackDirectionChoice = Choice<CrackDirection>;

/// The registry of direction rules.
CrackDirectionFamily& crack_directions();

}  // namespace dda
