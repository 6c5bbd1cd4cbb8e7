#include "models/interface/softening/softening_parameters.hpp"

namespace dda {
namespace {

/// Exponential softening, t = ft exp(−w ft/Gf): steep at first, with a tail that never ends.
Schema<SofteningParameters> schema() {
  return softening_schema("Exponential softening from the tensile strength, energy per area fixed.");
}

std::unique_ptr<InterfaceLaw> make(const SofteningParameters& p) {
  return std::make_unique<DamageLaw>(p.numbers(), exponential_shape());
}

}  // namespace

DDA_REGISTER(interface_laws(), "exponential_softening", schema(), make);

}  // namespace dda
