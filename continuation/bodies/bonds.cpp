#include "continuation/bodies/bonds.hpp"

#include <algorithm>
#include <cmath>

#include "models/interface/coulomb.hpp"

namespace dda {

Mat2 frame_of(const Bond& bond, const Poses& at) {
  const double one = polar_of(gradient_of(at[bond.first])).angle,
               other = polar_of(gradient_of(at[bond.second])).angle;
  const double mean = one + std::remainder(other - one, 2 * M_PI) / 2;
  const Vec2 n = rotation(mean) * bond.normal;
  return (Mat2() << n.x(), n.y(), -n.y(), n.x()).finished();
}

double turn_of(const Bond& bond, const Poses& at) {
  const auto angle = [&](std::size_t body) { return polar_of(gradient_of(at[body])).angle; };
  return std::abs(std::remainder(angle(bond.second) - angle(bond.first), 2 * M_PI));
}

void spend(Bond& bond, const Vec2& opening) {
  constexpr double all = 1e12;  // of its opening so far
  const double dissipated = bond.history.dissipated;
  bond.history = bond.law->releases_at_once() ? bond.law->release(opening, bond.history, bond.stiffness, 0)
                                              : bond.law->grown(bond.history, bond.stiffness, all);
  bond.history.dissipated = dissipated;
}

BondState state_of(const Bond& bond, const Mat2& local, const Poses& at) {
  BondState out;
  out.opening_rows = {-local * affine_rows(bond.at_first), local * affine_rows(bond.at_second)};
  out.opening = local * (place_of(at[bond.second], bond.at_second) - place_of(at[bond.first], bond.at_first));
  out.stress = bond.stress_first * green_strain(at[bond.first]) +
               bond.stress_second * green_strain(at[bond.second]) + bond.initial_stress;
  out.stress_rows = {bond.stress_first * green_strain_rows(at[bond.first]),
                     bond.stress_second * green_strain_rows(at[bond.second])};
  const Vec2 compliance = bond.trial_stiffness().cwiseInverse();
  out.opening += compliance.cwiseProduct(out.stress) + bond.multiplier;
  for (std::size_t i = 0; i < 2; ++i) out.opening_rows[i] += compliance.asDiagonal() * out.stress_rows[i];
  return out;
}

std::array<Vec6, 2> forces_of(const Bond& bond, const BondState& at, const Vec2& traction,
                              const Vec2& stress) {
  const Vec2 less = stress.cwiseQuotient(bond.trial_stiffness());
  std::array<Vec6, 2> out;
  for (std::size_t i = 0; i < 2; ++i)
    out[i] = bond.weight * (at.opening_rows[i].transpose() * traction - at.stress_rows[i].transpose() * less);
  return out;
}

Mat6 stiffness_of(const Bond& bond, const BondState& state, const Mat2& d,
                  const std::array<std::size_t, 2>& sides) {
  const auto [a, b] = sides;
  const Vec2 less = bond.trial_stiffness().cwiseInverse();
  return bond.weight * (state.opening_rows[a].transpose() * d * state.opening_rows[b] -
                        state.stress_rows[a].transpose() * less.asDiagonal() * state.stress_rows[b]);
}

namespace {

Response frozen_at(const Bond& bond, const History& history, const Vec2& opening, double closing) {
  const auto contact = bond.law->contact(history, bond.stiffness);
  if (!contact) return bond.law->respond_frozen(opening, history, bond.stiffness);
  const bool is_closed = opening.x() <= 0;
  const double normal = is_closed ? contact->closed : contact->open, bound = contact->coefficient * closing,
               slip = opening.y() - contact->slip;
  Response out;
  out.traction = {normal * opening.x(),
                  contact->shear * opening.y() + contact->friction * std::clamp(slip, -bound, bound)};
  out.tangent.diagonal() << normal, contact->shear + (std::abs(slip) < bound ? contact->friction : 0);
  return out;
}

}  // namespace

Response frozen_response(const Bond& bond, const Vec2& opening, double closing) {
  return frozen_at(bond, bond.history, opening, closing);
}

Mat2 secant_of(const Bond& bond, const Vec2& opening) {
  const History then = bond.law->accept(opening, bond.history, bond.stiffness);
  return frozen_at(bond, then, opening, closing_of(opening)).tangent;
}

double stored_energy(const Bond& bond, const BondState& state) {
  const double subtracted = state.stress.dot(state.stress.cwiseQuotient(bond.trial_stiffness())) / 2;
  return bond.weight * (bond.law->stored(state.opening, bond.history, bond.stiffness) - subtracted);
}

double spending(const Bond& bond, const BondState& state) {
  return bond.weight * bond.law->spending(state.opening, bond.history, bond.stiffness).value;
}

}  // namespace dda
