#pragma once

#include <string>
#include <utility>
#include <vector>

namespace dda::verification {

/// Guided cubes in a row, joined at the middle of their sides: a chain of springs with closed forms.
///
/// Block i stands from x = i a to (i + 1) a and has a uniform stress, the mean of what pulls at its two sides
/// plus nothing from forces at its centroid. Springs hold centroids; joint i is between blocks i and i + 1.
/// Lengths in mm, stresses in MPa, ν = 0.
struct Chain {
  static constexpr double side = 100, area = side * side, young = 30000;

  std::vector<std::string> laws;                     ///< YAML, one per joint
  std::string treatment = "penalty";                 ///< YAML
  bool held_left = true;                             ///< the left end stands against a wall
  std::vector<std::pair<int, double>> springs = {};  ///< block, stiffness [N/mm]
  std::string stages = pull();                       ///< YAML
  std::string path = "{stop: {load_below: 0}}";      ///< YAML

  /// A traction of 1 MPa at the right end.
  static std::string pull();
  /// The deck; its gauges are `elongation` of the whole, `tip` of the right end and `x0`, `x1`, … of the
  /// centroids.
  std::string deck() const;
};

}  // namespace dda::verification
