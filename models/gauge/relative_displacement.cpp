#include "models/body/place.hpp"
#include "models/gauge/gauge.hpp"

namespace dda {
namespace {

struct RelativeDisplacementParameters {
  Spot from, to;
  std::optional<Spot> from_inside, to_inside;
  std::optional<Vec2> direction;
  Position where;
};

/// Displacement of one point relative to another, l · (u_to − u_from): CMOD, CMSD, the opening of a joint.
class RelativeDisplacement final : public Gauge {
 public:
  explicit RelativeDisplacement(RelativeDisplacementParameters p) : p_(std::move(p)) {}
  Functional functional(const GaugeSources& sources) const override {
    const Assembly& assembly = sources.body.assembly;
    const Vec2 direction = p_.direction ? *p_.direction : locate(assembly, p_.to) - locate(assembly, p_.from);
    if (direction.norm() == 0)
      throw InputError(p_.where,
                       "`direction` is needed when `from` and `to` are the same point, and must not be zero");
    const Vec2 l = direction.normalized();
    Functional out = displacement_at(sources.body, {p_.to, p_.to_inside, {}}, l, p_.where);
    out.add(-1, displacement_at(sources.body, {p_.from, p_.from_inside, {}}, l, p_.where));
    return out;
  }
  Dimension dimension() const override { return dimension::length; }

 private:
  RelativeDisplacementParameters p_;
};

Schema<RelativeDisplacementParameters> schema() {
  using P = RelativeDisplacementParameters;
  return Schema<P>("Displacement of one point relative to another: CMOD, CMSD, an opening.")
      .spot("from", &P::from, {.text = "First point, or the name of one in `scene.points`."})
      .spot("from_inside", &P::from_inside, {.text = "A point inside the block that is meant at `from`."})
      .spot("to", &P::to, {.text = "Second point, or the name of one."})
      .spot("to_inside", &P::to_inside, {.text = "A point inside the block that is meant at `to`."})
      .point("direction", &P::direction,
             {.dimension = dimension::none,
              .text = "Direction (lx, ly), any length; from `from` to `to` if absent."});
}

}  // namespace

DDA_REGISTER(gauges(), "relative_displacement", schema(), make_of<RelativeDisplacement>);

}  // namespace dda
