#include "models/body/place_schema.hpp"
#include "models/gauge/gauge.hpp"

namespace dda {
namespace {

struct DisplacementParameters : Place {
  Vec2 direction = Vec2::Zero();
  Position where;
};

/// Displacement of a point, or mean displacement of a patch of the boundary, along a direction, l · u.
class Displacement final : public Gauge {
 public:
  explicit Displacement(DisplacementParameters p) : p_(std::move(p)) {}
  Functional functional(const GaugeSources& sources) const override {
    if (p_.direction.norm() == 0) throw InputError(p_.where, "`direction` must not be zero");
    return displacement_at(sources.body, p_, p_.direction.normalized(), p_.where);
  }
  Dimension dimension() const override { return dimension::length; }

 private:
  DisplacementParameters p_;
};

Schema<DisplacementParameters> schema() {
  using P = DisplacementParameters;
  Schema<P> s("Displacement of a point, or the mean over a patch of the boundary, along a direction.");
  add_place(s);
  return s.point("direction", &P::direction,
                 {.dimension = dimension::none, .text = "Direction (lx, ly), any length."});
}

}  // namespace

DDA_REGISTER(gauges(), "displacement", schema(), make_of<Displacement>);

}  // namespace dda
