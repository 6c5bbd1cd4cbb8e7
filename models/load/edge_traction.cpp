#include "models/body/place.hpp"
#include "models/load/load.hpp"

namespace dda {
namespace {

struct EdgeTractionParameters {
  std::string on;
  Vec2 traction = Vec2::Zero();
  double pressure = 0;
  Position where;
};

/// A traction on a named boundary: f += ∫ Tᵀ (τ − p n) dS, exact with two Gauss points per side.
class EdgeTraction final : public Load {
 public:
  explicit EdgeTraction(EdgeTractionParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    Vec2 total = Vec2::Zero();
    for (const BoundaryPoint& point : boundary_points(body, p_.on, p_.where)) {
      const Vec2 force = point.length * body.thickness * (p_.traction - p_.pressure * point.normal);
      add_point_force(stage, body, point.block, {point.x, force});
      total += force;
    }
    stage.resultant += total.norm();
  }

 private:
  EdgeTractionParameters p_;
};

Schema<EdgeTractionParameters> schema() {
  using P = EdgeTractionParameters;
  return Schema<P>("A traction or pressure on a named boundary.")
      .text("on", &P::on, {.text = "Name of the boundary."})
      .point("traction", &P::traction,
             {.fallback = Vec2(0, 0), .dimension = dimension::stress, .text = "Traction (tx, ty)."})
      .number(
          "pressure", &P::pressure,
          {.fallback = 0.0, .dimension = dimension::stress, .text = "Pressure against the outward normal."});
}

}  // namespace

DDA_REGISTER(loads(), "edge_traction", schema(), make_of<EdgeTraction>);

}  // namespace dda
