#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// An interface whose sides are too long for the cohesive zone in front of a crack.
///
///     h = Σ L²/Σ L          mean length of its sides [L]
///     l = E/(2 |dt/dw|)     by the steepest softening; E Gf/ft² where that is straight [L]
///
/// A crack's front, where the traction falls from strength to nothing, is about l long in a large body, and h
/// must leave it several points. Peaks of a notched beam (D/l from 10 to 50) against those of fine sides:
///
///     h/l                                    0.35      0.5       0.7       1         2.5
///     straight crack, linear softening       0.3 %     2 %       3-4 %     5 %       57 %
///     straight crack, exponential softening  0.5 %     0.7 %     2 %       2-6 %     18 %
///     Voronoi cells, linear softening        1.4 %     6 %       23 %
///
/// Past the limit of one half the error exceeds some 5 % in one mesh or another.
struct CoarseZone {
  std::size_t interface = 0;
  double side = 0, length = 0;  ///< h, l [L]
};

/// The interfaces with h above l/2; those of a single side, and what is released at once, are left out.
std::vector<CoarseZone> coarse_zones(const Simulation& simulation);

/// Those on which energy has been spent.
std::vector<CoarseZone> cracked_coarse_zones(const Simulation& simulation);

/// With numbers, and the size that would do.
std::string text(const Simulation& simulation, const CoarseZone& zone);

}  // namespace dda
