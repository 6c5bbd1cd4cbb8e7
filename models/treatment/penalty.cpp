#include <optional>

#include "models/treatment/spring_joint.hpp"

namespace dda {
namespace {

struct PenaltyParameters {
  double factor = 100;
  std::optional<double> stiffness;
};

/// Classic DDA: a spring of stiffness k across the joint, t = k g.
///
///     k = factor · E / (distance of the centroids),   E = 2 E_i E_j/(E_i + E_j)
///
/// Adds the compliance 1/k to every joint and locks quadrilateral and Voronoi blocks as k → ∞.
/// Source: Pearce et al. (2000), eq. 5.
class Penalty final : public SpringJoint {
 public:
  explicit Penalty(const PenaltyParameters& p) : SpringJoint(p.factor), given_(p.stiffness) {}

  double stiffness(const SideFaces& side) const override {
    return given_.value_or(SpringJoint::stiffness(side));
  }
  double largest_stiffness(const SideFaces& side) const override {
    return given_.value_or(SpringJoint::largest_stiffness(side));
  }

 private:
  std::optional<double> given_;
};

Schema<PenaltyParameters> schema() {
  using P = PenaltyParameters;
  return Schema<P>("Springs across the joint (classic DDA).")
      .number("factor", &P::factor,
              {.fallback = 100.0, .bounds = above(0), .text = "Stiffness in units of E/(centroid distance)."})
      .number("stiffness", &P::stiffness,
              {.dimension = dimension::interface_stiffness,
               .bounds = above(0),
               .text = "Absolute stiffness k; when given, `factor` is not used."});
}

}  // namespace

DDA_REGISTER(treatments(), "penalty", schema(), make_of<Penalty>);

}  // namespace dda
