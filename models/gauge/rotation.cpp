#include "models/body/rotation.hpp"

#include "models/body/place_schema.hpp"
#include "models/gauge/gauge.hpp"

namespace dda {
namespace {

struct RotationParameters : Place {
  double scale = 1;
  Position where;
};

/// Rotation θ of the blocks at a point, r0 in their mean, or of the straight line closest to a patch of the boundary.
class Rotation final : public Gauge {
 public:
  explicit Rotation(RotationParameters p) : p_(std::move(p)) {}
  Functional functional(const GaugeSources& sources) const override {
    Functional out;
    out.add(p_.scale, rotation_at(sources.body, p_, p_.where));
    return out;
  }
  Dimension dimension() const override { return dimension::none; }

 private:
  RotationParameters p_;
};

Schema<RotationParameters> schema() {
  using P = RotationParameters;
  Schema<P> s(
      "Rotation of the blocks at a point, or of a patch of the boundary in the mean, counter-clockwise "
      "[rad]; in a "
      "motion the sine of the turn.");
  add_place(s);
  return s.number("scale", &P::scale, {.fallback = 1.0, .text = "Factor, -1 to turn its sign."});
}

}  // namespace

DDA_REGISTER(gauges(), "rotation", schema(), make_of<Rotation>);

}  // namespace dda
