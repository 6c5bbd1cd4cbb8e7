#include "models/gauge/gauge.hpp"

namespace dda {
namespace {

struct LoadParameters {
  double scale = 1;
};

/// The load factor times a scale: a load in the units the user thinks in.
class LoadGauge final : public Gauge {
 public:
  explicit LoadGauge(LoadParameters p) : p_(p) {}
  Functional functional(const GaugeSources&) const override {
    return {.rows = {}, .per_load_factor = p_.scale};
  }
  Dimension dimension() const override { return dimension::force; }

 private:
  LoadParameters p_;
};

Schema<LoadParameters> schema() {
  using P = LoadParameters;
  return Schema<P>("The load factor times a scale.")
      .number("scale", &P::scale, {.dimension = dimension::force, .text = "Load at load factor 1."});
}

}  // namespace

DDA_REGISTER(gauges(), "load", schema(), make_of<LoadGauge>);

}  // namespace dda
