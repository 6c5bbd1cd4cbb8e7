#pragma once

#include <span>
#include <string>
#include <vector>

#include "models/body/body.hpp"
#include "models/body/place.hpp"
#include "models/parameters.hpp"

namespace dda {

/// A stiff spring to a fixed boundary: energy ½ p̄ (l · u − e)². Source: Pearce et al. (2000), eqs 10-15.
struct Spring {
  std::string reaction;      ///< name under which its force is summed; "" when nothing is borne in sum
  Functional displacement;   ///< l · u [L]
  double stiffness = 0;      ///< p̄ [F/L]
  std::string support = "";  ///< to which it belongs; "" of what a load drives
  double rest = 0;           ///< e, where it was put in [L]
  bool turns = false;        ///< it holds a rotation: l · u [-], p̄ [F L], its force a moment

  /// On the structure along l [F].
  double force(std::span<const double> d) const { return stiffness * (rest - displacement.value(d, 0)); }
};

/// The springs of all supports; positions outside the structure are findings.
std::vector<Spring> make_supports(const Body& body, const ModelParameters& model, Findings& findings);

/// Points of boundaries that supports hold along themselves, whatever the stage.
std::vector<BoundaryPoint> points_held_along(const Body& body, const ModelParameters& model);

/// A spring of a support that a stage puts in or takes away.
struct ChangingSpring {
  std::size_t spring = 0;  ///< place among those of all supports
  std::size_t stage = 0;   ///< among those with loads
};

/// Appends the springs of a support, which change in a stage.
void add_changing_springs(const std::vector<Spring>& supports, const std::string& name, std::size_t stage,
                          std::vector<ChangingSpring>& out);

/// Those that stages put in, in the order in which they come; a stage that there is not, or that is applied in full, is a
/// finding.
std::vector<ChangingSpring> added_springs(const std::vector<Spring>& supports, const ModelParameters& model,
                                          Findings& findings);

/// What planes of symmetry hold of the blocks on them, as springs on n · u at the ends of each side, of stiffness 1.
std::vector<Spring> springs_of_planes(const Body& body);

/// Rigid motions that no spring resists: one finding per connected group of blocks, motions named.
void check_rigid_motions(const Body& body, const std::vector<Spring>& springs, const Position& where,
                         Findings& findings);

}  // namespace dda
