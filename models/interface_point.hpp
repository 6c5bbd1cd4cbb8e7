#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/base/errors.hpp"
#include "models/body/body.hpp"
#include "models/interface/law.hpp"
#include "models/parameters.hpp"
#include "models/treatment/treatment.hpp"

namespace dda {

/// A jump across a cut as it enters the trial opening of a point.
struct JumpRows {
  BlockId node;  ///< behind the blocks
  Mat26 rows;
};

/// The gradient of a block's strain as it enters the trial opening of a point, and the mean traction there.
struct GradientRows {
  BlockId node;  ///< behind the blocks
  Mat26 rows;
  Mat26 stress = Mat26::Zero();
};

/// A point of an interface, or of a cut through a block: where the law is asked, and the rows that give its trial
/// opening.
///
///     q = first·d_first + second·d_second + Σ rows·g + Σ rows·e + m    (2 components, normal and tangential) [L]
///     its traction does work W t·δq,              W = share of the side's length × thickness   [L²]
///
/// g are the strain gradients of blocks of second order, e the jumps by which either side moves beside its block. On a cut both sides are parts of one block, which
/// is `first` and `second`, and q = g + P⁻¹ σn with the jump g of what lies right of it beside what lies left. m is there when the treatment has multipliers: two unknowns of the node `node`, or a number that the
/// continuation iterates.
struct InterfacePoint {
  BlockId first, second;
  Vec2 x, normal;        ///< place; normal outward of `first`
  double weight = 0;     ///< W [L²]
  double stiffness = 0;  ///< k [F/L³]
  const InterfaceLaw* law = nullptr;
  int interface = -1;  ///< index into InterfaceSet::names; −1 for a bond nobody named
  std::size_t side =
      0;  ///< index into Assembly::sides; of a cut through a block behind them, in the order of cuts
  std::optional<std::size_t> cut = {};  ///< index into CrackGeometry::cuts() where it stands on one
  bool is_awaited = false;  ///< it lies ahead of a crack, which goes on where it reaches its strength
  PointRows rows;
  std::vector<GradientRows> gradients = {};
  std::vector<JumpRows> jumps = {};
  Multiplier multiplier = Multiplier::none;
  BlockId node{0};                ///< of unknown multipliers; behind the blocks
  int column = 0;                 ///< of m in the node's six unknowns
  double perturbation = 0;        ///< δ of multipliers, t = (1 + δ) P m
  double physical_stiffness = 0;  ///< p̄ [F/L³]
  double spring_unit = 0;         ///< E/(centroid distance) [F/L³]
  double strength_factor = 1;     ///< of its interface's random field

  /// diag P = k (1, β²) [F/L³].
  Vec2 trial_stiffness() const {
    const double beta = law->shear_weight();
    return {stiffness, stiffness * beta * beta};
  }
  /// diag D0: of the joint as long as nothing has cracked [F/L³].
  Vec2 intact_stiffness() const { return law->intact_stiffness(stiffness); }
  /// Whether the stresses of the blocks enter q, as in a consistent joint.
  bool has_stresses() const { return !rows.first_stress.isZero() || !rows.second_stress.isZero(); }
  /// Whether the point is asked at run time: it can crack, or its multiplier is iterated.
  bool is_active() const { return law->can_crack() || multiplier == Multiplier::iterated; }

  /// Whether it joins a block to its own mirror image (models/treatment/mirrored.hpp).
  bool is_mirror() const { return first == second && !cut; }
  /// Whether it joins bodies that were never bonded: they only touch.
  bool is_separate() const { return law->contact({}, stiffness).has_value(); }

  /// Calls visit(block or node, rows 2 × 6) for each part of q.
  template <class Visit>
  void for_each_part(Visit visit) const {
    visit(first, rows.first);
    visit(second, rows.second);
    for (const GradientRows& gradient : gradients) visit(gradient.node, gradient.rows);
    for (const JumpRows& jump : jumps) visit(jump.node, jump.rows);
    if (multiplier == Multiplier::unknown) visit(node, multiplier_rows());
  }
  /// Calls visit(block or node, rows 2 × 6) for each part of {σ}n.
  template <class Visit>
  void for_each_stress(Visit visit) const {
    visit(first, rows.first_stress);
    visit(second, rows.second_stress);
    for (const GradientRows& gradient : gradients) visit(gradient.node, gradient.stress);
  }
  /// Rows that pick m out of its node.
  Mat26 multiplier_rows() const {
    Mat26 out = Mat26::Zero();
    out.block<2, 2>(0, column).setIdentity();
    return out;
  }
};

/// All interface points with the laws they use. Points that are asked at run time come first.
struct InterfaceSet {
  std::vector<std::string> names;
  std::vector<std::string> locked;  ///< why those with multipliers lock that do, see models/locked_joints.hpp
  std::vector<std::shared_ptr<const InterfaceLaw>> laws;
  std::vector<InterfacePoint> points;
  std::vector<std::size_t> touched;  ///< sides that cuts divide or that a cut block has, in their order
  std::size_t num_active = 0;
  std::size_t num_nodes = 0;         ///< of unknown multipliers, one per side
  bool has_fields = false;           ///< some interface varies in space
  bool has_water = false;            ///< some interface has water in its cracks
  std::vector<std::string> notices;  ///< what was adapted, and what locks, for the log

  std::size_t num_crackable() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(points, [](const InterfacePoint& p) { return p.law->can_crack(); }));
  }
};

/// Makes the points of every side: which interface, which treatment, which stiffness.
///
/// Where the interface has a random field each point has a law of its own, scaled by the field at its place.
/// A law that softens with slope |dt/dw| needs k above it; a side whose own k is too small gets a larger one
/// (and a notice); a block too large even then is a finding at the interface's position in the deck.
///
/// The inner sides of regions through whose blocks cracks run are bonded. Where cuts end on a bond each piece of it
/// has points of its own; points that remember something stay (models/jump_rows.hpp). Points of
/// cuts come behind those of sides, in the order of the cuts, so that more cuts add points at the end of each group.
InterfaceSet make_interface_points(const Body& body, const ModelParameters& model, Findings& findings);

/// Makes a set that has no unknown multipliers the one for the cuts that there are now, bit for bit but for its notices,
/// which stay: only sides that cuts touch, or have touched, get other points. Left as it is where there are findings.
void remake_interface_points(const Body& body, const ModelParameters& model, Findings& findings,
                             InterfaceSet& set);

}  // namespace dda
