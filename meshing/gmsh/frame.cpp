#include "meshing/gmsh/frame.hpp"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr double extent = 1000, grid = 0x1p-30;
constexpr int bits = 40;

Vec2 on_grid(const Vec2& x) { return {grid * std::round(x.x() / grid), grid * std::round(x.y() / grid)}; }

}  // namespace

Frame::Frame(const Layout& layout) {
  if (layout.shapes.empty()) return;
  axes_ = axes_along(layout.shapes.front().figure.outline);
  Vec2 least = Vec2::Constant(INFINITY), most = -least;
  for (const Shape& shape : layout.shapes)
    for (const Vec2& x : shape.figure.outline.vertices) {
      const Vec2 turned = axes_.transpose() * x;
      least = least.cwiseMin(turned), most = most.cwiseMax(turned);
    }
  const double size = (most - least).maxCoeff();
  is_own_ = true;
  origin_ = least;
  scale_ = extent / size;
}

Vec2 Frame::inner(const Vec2& x) {
  const Vec2 out = on_grid(scale_ * (axes_.transpose() * x - origin_));
  given_.try_emplace({out.x(), out.y()}, x);
  return out;
}

double Frame::inner(double length) const {
  if (!is_own_ || length == 0) return length;
  const double step = std::ldexp(1, std::ilogb(scale_ * length) - bits);
  return step * std::round(scale_ * length / step);
}

Vec2 Frame::outer(const Vec2& inner) const {
  if (!is_own_) return inner;
  const Vec2 rounded = on_grid(inner);
  const auto found = given_.find({rounded.x(), rounded.y()});
  return found == given_.end() ? Vec2(axes_ * (origin_ + inner / scale_)) : found->second;
}

}  // namespace dda
