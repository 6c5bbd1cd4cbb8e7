#pragma once

#include <algorithm>
#include <string>

#include "framework/base/vec2.hpp"
#include "framework/figure/axis.hpp"
#include "framework/figure/canvas.hpp"

namespace dda::svg {

/// Where a drawing stands on the picture, and the least room it gets [px].
inline constexpr double drawing_margin = 16, least_height = 120;

/// From the plane to the picture: equal scale, y upwards, centred in a frame.
class View {
 public:
  /// Bounds in the plane, and the room for them [px].
  View(const Range& x, const Range& y, double room_across, double room_down) : x_(x), y_(y) {
    const double width = std::max(x.high - x.low, 1e-300), height = std::max(y.high - y.low, 1e-300);
    scale_ = std::min(room_across / width, room_down / height);
    frame_ = {drawing_margin, drawing_margin, std::max(width * scale_, 2 * least_height),
              std::max(height * scale_, least_height)};
  }

  const Box& frame() const { return frame_; }
  void move_by(double right, double down) {
    frame_.x += right;
    frame_.y += down;
  }
  double across(const Vec2& point) const {
    return frame_.x + frame_.width / 2 + scale_ * (point.x() - x_.low - (x_.high - x_.low) / 2);
  }
  double down(const Vec2& point) const {
    return frame_.y + frame_.height / 2 - scale_ * (point.y() - y_.low - (y_.high - y_.low) / 2);
  }
  /// On the picture, y downwards [px].
  Vec2 pixel(const Vec2& point) const { return {across(point), down(point)}; }
  std::string place(const Vec2& point) const {
    return coordinate(across(point)) + " " + coordinate(down(point));
  }

 private:
  Range x_, y_;
  Box frame_;
  double scale_ = 1;
};

}  // namespace dda::svg
