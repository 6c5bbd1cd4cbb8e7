#pragma once

namespace dda {

/// Contacts that are springs, which open and close between the linear systems of a step.
struct OpenCloseRules {
  double penalty = 10;         ///< stiffness along the normal, in E · thickness
  double shear_share = 0.4;    ///< of that, along the edge
  double displacement = 0.01;  ///< the farthest that a corner goes in a step, in sizes of the smallest body
  int most_passes = 6;         ///< linear systems in which states may change
};

}  // namespace dda
