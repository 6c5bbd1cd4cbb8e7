#include <optional>

#include "models/treatment/treatment.hpp"

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
class Penalty final : public Treatment {
 public:
  explicit Penalty(const PenaltyParameters& p) : p_(p) {}

  double stiffness(const SideFaces& side) const override {
    return p_.stiffness.value_or(p_.factor * spring_unit(side));
  }
  double largest_stiffness(const SideFaces& side) const override {
    return p_.stiffness.value_or(std::max(p_.factor, largest_factor) * spring_unit(side));
  }
  PointRows rows(const SideFaces& side, const Mat26& first, const Mat26& second, const Vec2&) const override {
    return jump_rows(side.normal, first, second);
  }
  Vec2 stress_weights(const SideFaces&) const override { return Vec2::Zero(); }

 private:
  static constexpr double largest_factor = 1e4;
  PenaltyParameters p_;
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

std::unique_ptr<Treatment> make(const PenaltyParameters& p) { return std::make_unique<Penalty>(p); }

}  // namespace

DDA_REGISTER(treatments(), "penalty", schema(), make);

}  // namespace dda
