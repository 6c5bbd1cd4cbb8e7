#pragma once

#include <utility>
#include <vector>

#include "models/parameters.hpp"

namespace dda {

/// Where points stand on a side, as shares of its length, and their weights, which sum to 1.
using PointsOfSide = std::vector<std::pair<double, double>>;

/// Gauss-Legendre's rules, exact to degrees 3 and 5.
PointsOfSide two_gauss_points();
PointsOfSide three_gauss_points();

/// On a side between blocks of first order.
PointsOfSide points_of_side(PointRule rule);

/// Whether the points of a rule bear blocks of second order. Its two ends overrate |σn|² threefold, its middle leaves a
/// mechanism.
bool integrates_linear_stress(PointRule rule);

}  // namespace dda
