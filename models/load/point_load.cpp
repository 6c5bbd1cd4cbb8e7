#include "models/load/load.hpp"
#include "models/place_schema.hpp"

namespace dda {
namespace {

struct PointLoadParameters : Place {
  Vec2 force = Vec2::Zero();
  Position where;
};

/// A force at a point, f += Tᵀ F; blocks that meet at the point share it equally.
class PointLoad final : public Load {
 public:
  explicit PointLoad(PointLoadParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    const auto blocks = blocks_of(body.assembly, p_, p_.where);
    for (const BlockId id : blocks)
      add_point_force(stage, body, id, p_.at, p_.force / static_cast<double>(blocks.size()));
    stage.resultant += p_.force.norm();
  }

 private:
  PointLoadParameters p_;
};

Schema<PointLoadParameters> schema() {
  using P = PointLoadParameters;
  Schema<P> s("A force at a point.");
  add_place(s);
  return s.point("force", &P::force, {.dimension = dimension::force, .text = "Force (Fx, Fy)."});
}

std::unique_ptr<Load> make(const PointLoadParameters& p) { return std::make_unique<PointLoad>(p); }

}  // namespace

DDA_REGISTER(loads(), "point_load", schema(), make);

}  // namespace dda
