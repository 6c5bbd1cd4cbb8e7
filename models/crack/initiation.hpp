#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "models/body/body.hpp"
#include "models/body/place.hpp"
#include "models/body/random_field.hpp"

namespace dda {

constexpr double next_to_a_crack = 4;  ///< in block sizes: what it relieves in any case

/// A place at which stress asks for a crack.
struct CrackStart {
  Vec2 at, direction;      ///< on the outline of a block, and into it
  double load_factor = 0;  ///< at which tension reaches the strength there
};

/// Stress of every block, σ + λ dσ/dλ: (σx, σy, τxy) [F/L²].
struct BlockStress {
  std::vector<Vec3> dead, live;
};

/// A re-entrant corner ahead of which there are too few blocks to tell its tension.
struct ShallowCorner {
  Vec2 at;
  double depth = 0;  ///< of the body ahead of it [block sizes]
};

/// What tension has to reach in a region [F/L²]: ft f(x), f of the random field of its law, as at the points of cracks.
struct LocalStrength {
  double mean = 0;                     ///< ft
  const RandomField* field = nullptr;  ///< none: 1 everywhere

  double at(const Vec2& x) const { return field ? mean * field->factor(x) : mean; }
};

/// Where new cracks begin: on the boundary of some regions and where they meet interfaces, at sides that no crack comes
/// near; within R = 3 h of a re-entrant corner, as of the tip of a slit, at the corner. Tension at a place is that of a
/// linear field, fitted to the stresses of the blocks within R that a straight line through the body leads to:
///
///     Σ |σ_b − (s + G (x_b − x))|² → min        σ(x) = s
///
/// since blocks of constant strain bear at their middle what the edge bears further out. At a corner, where tension has no
/// bound, it is s of s (ρ/r)ᵉ + G (x_b − x), ρ = h/4, fitted likewise, with e of the corner's angle (singularity_of).
/// With it the smallest λ ≥ 0 is found for which the largest principal value of σ(x) is the strength ft f(x) there, and the
/// crack runs across its axis, at a corner that of the linear field. Where that would be along an edge, tension along the edge
/// counts instead.
class CrackStarts {
 public:
  CrackStarts(const CrackGeometry& cracks, const Body& body) : cracks_(cracks), body_(body) {}

  struct Wish {
    std::map<int, LocalStrength> strength;  ///< of the regions that may crack
    double apart = 0;                       ///< least distance to any cut, through the body [L]
    std::optional<int> except = {};         ///< a crack whose cuts do not count
    std::span<const BoundaryPoint> held =
        {};  ///< where supports hold the boundary along itself: nothing opens there
  };
  /// Those with a finite λ, the smallest first; places of the same λ in the order of the assembly.
  std::vector<CrackStart> places(const BlockStress& stress, const Wish& wish) const;
  /// Corners of these regions with less than four blocks ahead of them.
  std::vector<ShallowCorner> shallow(const std::map<int, LocalStrength>& strength) const;

 private:
  const CrackGeometry& cracks_;
  const Body& body_;
};

}  // namespace dda
