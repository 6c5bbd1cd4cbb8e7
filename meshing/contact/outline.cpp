#include "meshing/contact/outline.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace dda {
namespace {

/// A directed straight line.
struct Line {
  Vec2 at, along;
};

std::vector<Line> moved_sides(const Polygon& outline, double offset) {
  std::vector<Line> out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 along = (outline.at(i + 1) - outline.at(i)).normalized();
    out.push_back({outline.at(i) + offset * Vec2(-along.y(), along.x()), along});
  }
  return out;
}

/// Where b follows a; the middle of where they begin for sides of one line.
Vec2 corner(const Line& a, const Line& b) {
  constexpr double parallel = 1e-9;
  const double sine = cross(a.along, b.along);
  if (std::abs(sine) < parallel) return b.at;
  return a.at + cross(b.at - a.at, b.along) / sine * a.along;
}

}  // namespace

Polygon core_of(const Polygon& outline, double offset) {
  std::vector<Line> sides = moved_sides(outline, offset);
  while (sides.size() >= 3) {
    Polygon core;
    const std::size_t n = sides.size();
    for (std::size_t i = 0; i < n; ++i) core.vertices.push_back(corner(sides[(i + n - 1) % n], sides[i]));
    double shortest = std::numeric_limits<double>::infinity();
    std::size_t turned = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double length = (core.at(i + 1) - core.at(i)).dot(sides[i].along);
      if (length >= shortest) continue;
      shortest = length;
      turned = i;
    }
    if (shortest > 0) return core;
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(turned));
  }
  throw std::domain_error("narrower than twice the offset of its core");
}

}  // namespace dda
