#include <cmath>

#include "framework/deck/formula.hpp"
#include "models/body/place.hpp"
#include "models/load/load.hpp"
#include "models/load/quadrature.hpp"

namespace dda {
namespace {

struct EdgeTractionParameters {
  std::string boundary;
  VectorFormula traction;
  Formula pressure;
  Position where;
};

/// A traction on a named boundary, f += ∫ Tᵀ (τ − p n) dS.
///
/// T is linear along a piece of a side, so that two forces at its Gauss points ξ₁, ξ₂ have the same effect, those with
/// the resultant F = ∫ t ds and the first moment M = ∫ ξ t ds of the traction t: exact where it is even, else to 1e-11.
class EdgeTraction final : public Load {
 public:
  explicit EdgeTraction(EdgeTractionParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    const std::vector<BoundaryPoint> points = boundary_points(body, p_.boundary, p_.where);
    Vec2 total = Vec2::Zero();
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
      const Pair forces = forces_at(points[i], points[i + 1], body.thickness);
      add_point_force(stage, body, points[i].block, {points[i].x, forces.first});
      add_point_force(stage, body, points[i].block, {points[i + 1].x, forces.second});
      total += forces.first + forces.second;
    }
    stage.resultant += total.norm();
  }

 private:
  using Pair = std::pair<Vec2, Vec2>;

  Vec2 traction(const Vec2& x, const Vec2& normal) const { return p_.traction(x) - p_.pressure(x) * normal; }

  /// At the two Gauss points of a piece; ξ runs from the first to the second.
  Pair forces_at(const BoundaryPoint& first, const BoundaryPoint& second, double thickness) const {
    if (p_.traction.is_constant() && p_.pressure.is_constant()) {
      const Vec2 force = first.length * thickness * traction(first.x, first.normal);
      return {force, force};
    }
    const double beyond = (std::sqrt(3.0) - 1) / 2;
    const Vec2 way = second.x - first.x;
    const Integrals found = way.norm() * thickness *
                            integral(
                                -beyond, 1 + beyond,
                                [&](double xi) {
                                  const Vec2 t = traction(first.x + xi * way, first.normal);
                                  Integrals out = Integrals::Zero();
                                  out << t, xi * t, 0, 0;
                                  return out;
                                },
                                halvings_of_side(p_.traction.is_plain() && p_.pressure.is_plain()));
    const Vec2 force = found.head<2>(), moment = found.segment<2>(2);
    return {force - moment, moment};
  }

  EdgeTractionParameters p_;
};

Schema<EdgeTractionParameters> schema() {
  using P = EdgeTractionParameters;
  return Schema<P>("A traction or pressure on a named boundary, even or a function of x and y.")
      .text("boundary", &P::boundary, {.text = "Name of the boundary."})
      .value("traction", &P::traction, vector_formula_kind(dimension::stress),
             {.fallback = VectorFormula(),
              .text = "Traction (tx, ty), each a number or an expression of x and y."})
      .value("pressure", &P::pressure, formula_kind(dimension::stress),
             {.fallback = Formula(),
              .text = "Pressure against the outward normal, a number or an expression of x and y; of water "
                      "up to a level H \"rho*g*max(0, H - y)\"."});
}

}  // namespace

DDA_REGISTER(loads(), "edge_traction", schema(), make_of<EdgeTraction>);

}  // namespace dda
