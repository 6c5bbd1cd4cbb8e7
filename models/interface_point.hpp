#pragma once

#include <memory>
#include <string>
#include <vector>

#include "framework/errors.hpp"
#include "models/body.hpp"
#include "models/interface/law.hpp"
#include "models/parameters.hpp"
#include "models/treatment/treatment.hpp"

namespace dda {

/// A point of an interface: where the law is asked, and the rows that give its trial opening.
///
///     q = first·d_first + second·d_second     (2 components, normal and tangential)   [L]
///     its traction does work W t·δq,          W = share of the side's length × thickness   [L²]
struct InterfacePoint {
  BlockId first, second;
  Vec2 x, normal;        ///< place; normal outward of `first`
  double weight = 0;     ///< W [L²]
  double stiffness = 0;  ///< k [F/L³]
  const InterfaceLaw* law = nullptr;
  int interface = -1;    ///< index into InterfaceSet::names; −1 for a bond nobody named
  std::size_t side = 0;  ///< index into Assembly::sides
  PointRows rows;

  /// diag P = k (1, β²) [F/L³].
  Vec2 trial_stiffness() const {
    const double beta = law->shear_weight();
    return {stiffness, stiffness * beta * beta};
  }
};

/// All interface points with the laws they use. Points that can crack come first.
struct InterfaceSet {
  std::vector<std::string> names;
  std::vector<std::shared_ptr<const InterfaceLaw>> laws;
  std::vector<InterfacePoint> points;
  std::size_t num_crackable = 0;
  std::vector<std::string> notices;  ///< what was adapted, for the log
};

/// Makes the points of every side: which interface, which treatment, which stiffness.
///
/// A law that softens with slope |dt/dw| needs k above it; a side whose own k is too small gets a larger one
/// (and a notice); a block too large even then is a finding at the interface's position in the deck.
InterfaceSet make_interface_points(const Body& body, const ModelParameters& model, Findings& findings);

}  // namespace dda
