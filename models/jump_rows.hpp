#pragma once

#include <utility>
#include <vector>

#include "models/body/body.hpp"
#include "models/interface_point.hpp"

namespace dda {

/// A straight line with interface points on it.
struct PointLine {
  Vec2 start, end, normal;
  std::vector<std::pair<double, double>> points;  ///< shares of its length: where each stands, and its weight
};

/// By which jumps a point's trial opening moves, of each point of a line. A jump along all of it enters by its value at
/// the point. Where another crack ends on the line a jump moves but a piece of it; then the point has what its share N of
/// a traction that varies linearly along the line works on there,
///
///     rows_i = 1/w_i ∫_piece N_i(s) [n s]ᵀ J(s) ds        N_i(s_j) = δ_ij
///
/// so that each piece is in equilibrium under a uniform traction, and the points and what they remember stay.
using JumpsOfPoints = std::vector<std::vector<JumpRows>>;

/// On a side or a stretch of it: what lies behind it, of the second block, beside what lies before it, of the first.
JumpsOfPoints jumps_along_side(const Body& body, std::size_t side, const PointLine& line);
/// On a cut through a block: what lies right of it beside what lies left.
JumpsOfPoints jumps_along_cut(const Body& body, const Cut& cut, const PointLine& line);

}  // namespace dda
