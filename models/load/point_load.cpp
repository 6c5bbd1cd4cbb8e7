#include "models/body/place_schema.hpp"
#include "models/load/load.hpp"

namespace dda {
namespace {

struct PointLoadParameters : Place {
  Vec2 force = Vec2::Zero();
  Position where;
};

/// A force at a point, f += Tᵀ F, which blocks that meet at the point share equally; or the same force as an
/// even traction over a patch of the boundary.
class PointLoad final : public Load {
 public:
  explicit PointLoad(PointLoadParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    const Functional x = displacement_at(body, p_, Vec2::UnitX(), p_.where);
    const Functional y = displacement_at(body, p_, Vec2::UnitY(), p_.where);
    x.add_gradient(p_.force.x(), stage.force);
    y.add_gradient(p_.force.y(), stage.force);
    stage.resultant += p_.force.norm();
  }
  std::optional<Action> action() const override { return Action{p_, p_.force}; }

 private:
  PointLoadParameters p_;
};

Schema<PointLoadParameters> schema() {
  using P = PointLoadParameters;
  Schema<P> s("A force at a point, or spread evenly over a patch of the boundary.");
  add_place(s);
  return s.point("force", &P::force, {.dimension = dimension::force, .text = "Force (Fx, Fy)."});
}

}  // namespace

DDA_REGISTER(loads(), "point_load", schema(), make_of<PointLoad>);

}  // namespace dda
