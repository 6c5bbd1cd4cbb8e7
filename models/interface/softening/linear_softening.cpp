#include "models/interface/softening/softening_parameters.hpp"

namespace dda {
namespace {

/// Linear softening down to a stress-free crack at w_c = 2 Gf/ft: t = ft (1 − w/w_c).
Schema<SofteningParameters> schema() {
  return softening_schema(
      "Linear softening from the tensile strength to a stress-free crack, energy per area fixed.");
}

std::unique_ptr<InterfaceLaw> make(const SofteningParameters& p) {
  return std::make_unique<DamageLaw>(p.numbers(), piecewise_linear_shape({{0, 1}, {2, 0}}));
}

}  // namespace

DDA_REGISTER(interface_laws(), "linear_softening", schema(), make);

}  // namespace dda
