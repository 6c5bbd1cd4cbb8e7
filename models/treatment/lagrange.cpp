#include <algorithm>

#include "models/treatment/spring_joint.hpp"

namespace dda {
namespace {

struct LagrangeParameters {
  double factor = 10;
  double perturbation = 1e-7, contact_perturbation = 1e-3;
};

/// Lagrange multipliers: the joint is closed exactly, the multiplier m of a point being two more unknowns.
///
///     q = g + m,   Π = Π_blocks + ∫ ψ(q; h) − ½ (1 + δ) ∫ m·P m
///     ∂Π/∂m = 0:   t(g + m; h) = (1 + δ) P m         a bond: g = δ m, a crack: its own opening
///
/// K is symmetric and indefinite, with a zero (−δ W P) on the diagonal for every bond. Two points on each
/// side of a quadrilateral or Voronoi block are more equations than unknowns: some multipliers are redundant,
/// and δ picks the smallest of them; the gap it leaves is δ P⁻¹ t, and rounding leaves about 1e-16/δ of them.
/// The run reports their number. Bodies that only touch are pressed together by many points, which rigid ones
/// and strong friction can wedge without limit: they get a larger δ, still a gap of 1e-4 of what the blocks
/// themselves give. P only scales m and carries softening. Source: Pearce et al. (2000), eq. 6;
/// models/README.md.
class Lagrange final : public SpringJoint {
 public:
  explicit Lagrange(const LagrangeParameters& p)
      : SpringJoint(p.factor), perturbation_(p.perturbation), contact_perturbation_(p.contact_perturbation) {}

  Multiplier multiplier() const override { return Multiplier::unknown; }
  double perturbation(bool is_separate) const override {
    return is_separate ? contact_perturbation_ : perturbation_;
  }
  double physical_stiffness(const SideFaces& side) const override {
    constexpr double closed =
        1e6;  // stiff enough to be a tie, soft enough for eigenvalues to keep their digits
    return std::max(stiffness(side), closed * spring_unit(side));
  }

 private:
  double perturbation_, contact_perturbation_;
};

Schema<LagrangeParameters> schema() {
  using P = LagrangeParameters;
  return Schema<P>(
             "Lagrange multipliers: exact, with two more unknowns per point; locks polygons that are bonded.")
      .number("factor", &P::factor,
              {.fallback = 10.0,
               .bounds = above(0),
               .text = "Scale of the multipliers in units of E/(centroid distance); the solution does not "
                       "depend on it."})
      .number(
          "perturbation", &P::perturbation,
          {.fallback = 1e-7,
           .bounds = above(0) & at_most(1e-3),
           .text = "Gap left in a joint, relative to that of springs of this stiffness; determines redundant "
                   "multipliers."})
      .number("contact_perturbation", &P::contact_perturbation,
              {.fallback = 1e-3,
               .bounds = above(0) & at_most(1e-3),
               .text = "The same where bodies only touch (law `friction`): rigid points that are pressed "
                       "together may be wedged by strong friction."});
}

}  // namespace

DDA_REGISTER(treatments(), "lagrange", schema(), make_of<Lagrange>);

}  // namespace dda
