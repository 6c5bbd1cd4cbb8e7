// Joints of a motion that lose what they hold within a step.
#include <algorithm>

#include "continuation/motion/motion_try.hpp"
#include "continuation/state/reach.hpp"

namespace dda {

/// Of the bonds that lose their strength at once those that a step has brought farthest beyond it, and others nearly as far:
/// what the others have to bear then is not known before.
std::vector<Motion::Overload> Motion::overloads(const Poses& reached) const {
  constexpr double nearly = 0.9, round_off = 1e-9;
  std::vector<Overload> out;
  double farthest = 1 + round_off;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    if (!bond.can_tear() || !bond.law->releases_at_once() || bond.is_spent()) continue;
    const LawAt law{*bond.law, bond.history, bond.stiffness};
    const Vec2 from = potential_->state_of(i, now_).opening, to = potential_->state_of(i, reached).opening;
    const double beyond = law.opening(to) / law.kappa();
    if (!(beyond > 1 + round_off)) continue;
    farthest = std::max(farthest, beyond);
    out.push_back({i, beyond, from + share_to_kappa(law, from, to, 0) * (to - from)});
  }
  std::erase_if(out, [&](const Overload& overload) { return overload.beyond < nearly * farthest; });
  return out;
}

/// They have lost it where they reached it on their way; what they bore there beyond friction is spent.
void Motion::lose_strength(const std::vector<Overload>& overloads) {
  for (const Overload& overload : overloads) {
    Bond& bond = bonds_[overload.bond];
    const auto accept = [&] {
      bond.history = bond.law->accept(overload.opening, bond.history, bond.stiffness);
    };
    const History before = bond.history;
    accept();
    bond.history = bond.law->release(overload.opening, bond.history, bond.stiffness, 0);
    accept();
    given_up_.push_back({overload.bond, before, bond.weight * (bond.history.dissipated - before.dissipated)});
  }
}

/// Before the step is tried at another length.
void Motion::take_back_strength() {
  for (auto lost = given_up_.rbegin(); lost != given_up_.rend(); ++lost)
    bonds_[lost->bond].history = lost->before;
  given_up_.clear();
}

/// Whether joints have torn in a step that was too long for them to slow down what they held: the work of the tractions
/// that move the bodies, in the first step where velocities are means but half of it, lacks too much of what the joints have
/// stored and spent.
bool Motion::tears_unfelt(const Try& step) const {
  constexpr double of_spent = 0.01, of_kinetic = 1e-4;
  if (!(step.entry.fracture > 0) || !course_.integrator->has_inertia()) return false;
  const double end = course_.integrator->share_of_end(),
               moving = m_.dt.begins && course_.integrator->has_mean_velocities() ? 0.5 : 1;
  double unfelt = 0;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    if (!bond.can_tear()) continue;
    const Vec2 from = potential_->state_of(i, now_).opening,
               to = potential_->state_of(i, step.found.poses).opening;
    const double spent = bond.law->spending(to, bond.history, bond.stiffness).value;
    if (!(spent > 0)) continue;
    const auto stored = [&](const Vec2& q) { return bond.law->stored(q, bond.history, bond.stiffness); };
    const auto traction = [&](const Vec2& q) {
      return bond.law->respond(q, bond.history, bond.stiffness).traction;
    };
    const Vec2 mean = end * traction(to) + (1 - end) * traction(from);
    const double work = moving * mean.dot(to - from);
    unfelt += bond.weight * std::max(0.0, stored(to) - stored(from) + spent - work);
  }
  return unfelt >
         std::max(of_spent * step.entry.fracture, of_kinetic * std::max(m_.most_kinetic, step.entry.kinetic));
}

}  // namespace dda
