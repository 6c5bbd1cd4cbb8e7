#include "models/interface/softening/softening_parameters.hpp"

namespace dda {
namespace {

struct BilinearParameters : SofteningParameters {
  double knee_stress = 1.0 / 3;
  double initial_share = 0.6;
};

/// Bilinear softening, by default Petersson's: from ft at w = 0 over ft/3 at 0.8 Gf/ft to 0 at 3.6 Gf/ft.
///
///     knee at (w_k, s ft),  w_k ft/Gf = 2 a (1 − s),  end at w_c ft/Gf = (2 − w_k ft/Gf)/s
///
/// a Gf is the area under the first branch drawn down to zero.
Schema<BilinearParameters> schema() {
  using P = BilinearParameters;
  return softening_schema<P>("Bilinear softening (Petersson's curve by default), energy per area fixed.")
      .number("knee_stress", &P::knee_stress,
              {.fallback = 1.0 / 3,
               .bounds = strictly_between(0, 1),
               .text = "Traction at the knee in units of the tensile strength."})
      .number("initial_share", &P::initial_share,
              {.fallback = 0.6,
               .bounds = strictly_between(0, 1),
               .text = "Area under the first branch, drawn down to zero, in units of Gf."});
}

std::unique_ptr<InterfaceLaw> make(const BilinearParameters& p) {
  const double knee = 2 * p.initial_share * (1 - p.knee_stress), end = (2 - knee) / p.knee_stress;
  return std::make_unique<DamageLaw>(p.numbers(),
                                     piecewise_linear_shape({{0, 1}, {knee, p.knee_stress}, {end, 0}}));
}

}  // namespace

DDA_REGISTER(interface_laws(), "bilinear_softening", schema(), make);

}  // namespace dda
