#pragma once

#include <string>
#include <vector>

#include "models/body/body.hpp"
#include "models/parameters.hpp"

namespace dda {

/// A stiff spring to a fixed boundary: energy ½ p̄ (l · u)². Source: Pearce et al. (2000), eqs 10-15.
struct Spring {
  std::string reaction;     ///< name under which its force is summed; "" when nothing is borne in sum
  Functional displacement;  ///< l · u [L]
  double stiffness = 0;     ///< p̄ [F/L]
};

/// The springs of all supports; positions outside the structure are findings.
std::vector<Spring> make_supports(const Body& body, const ModelParameters& model, Findings& findings);

/// Rigid motions that no spring resists: one finding per connected group of blocks, motions named.
void check_rigid_motions(const Body& body, const std::vector<Spring>& springs, const Position& where,
                         Findings& findings);

}  // namespace dda
