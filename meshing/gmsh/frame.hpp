#pragma once

#include <map>

#include "meshing/layout.hpp"

namespace dda {

/// Coordinates in which gmsh divides polygons: along the first side of the first one, from the lower left corner
/// of the layout, its larger extent 1000, rounded to 2⁻³⁰; lengths to 40 bits.
///
/// gmsh's elements hang on the last bits of what it is given, and its tolerances are lengths. So it is given the same
/// numbers for the same polygons, whatever their unit, place and turn.
class Frame {
 public:
  Frame() = default;  ///< a file's own coordinates
  explicit Frame(const Layout& layout);

  Vec2 inner(const Vec2& x);            ///< of a point of the layout, which `outer` gives back exactly
  Vec2 outer(const Vec2& inner) const;  ///< where the layout has what gmsh has at `inner`
  double inner(double length) const;

 private:
  bool is_own_ = false;
  Eigen::Matrix2d axes_ = Eigen::Matrix2d::Identity();  // unit vectors of the inner axes, as columns
  Vec2 origin_ = Vec2::Zero();                          // along these
  double scale_ = 1;
  std::map<std::pair<double, double>, Vec2> given_;  // by their inner coordinates
};

}  // namespace dda
