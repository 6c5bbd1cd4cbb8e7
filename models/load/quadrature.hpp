#pragma once

#include <functional>

#include "meshing/geometry/polygon.hpp"

namespace dda {

/// Up to six integrals at once.
using Integrals = Eigen::Matrix<double, 6, 1>;

/// ∫ f dt from a to b. Gauss-Lobatto's rule with five points, exact to degree 7, on as many parts as it takes: an interval is halved
/// until both halves together say what it says itself, to 1e-11 of the whole. A kink or a jump of f costs some dozens of
/// halvings where it is; after 2000 it is left at what has been reached. Every part is halved so many times at least: what is
/// narrower than the points that this takes lie apart, a hundredth of the interval for five halvings, may be missed.
Integrals integral(double a, double b, const std::function<Integrals(double)>& f, int least_halvings = 0);

/// ∫ f dA over a simple polygon, which is cut into trapezoids between its vertices' abscissae: f is asked inside only. What is
/// narrower than a quarter of it may be missed: to look closer takes the square of the points, in every block.
Integrals integral(const Polygon& polygon, const std::function<Integrals(const Vec2&)>& f);

/// How often to halve a side for an expression: one that is plain as often as it takes.
inline int halvings_of_side(bool is_plain) { return is_plain ? 0 : 5; }

}  // namespace dda
