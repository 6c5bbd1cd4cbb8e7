#include "models/interface/softening/damage_law.hpp"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

/// Share of κ within which a point stands on its surface: events are met as closely, and what has been
/// flagged there as loading must load.
constexpr double on_surface = 1e-10;
constexpr double together = 1e-9;

struct Memory {
  double kappa = 0;    ///< κ, largest equivalent trial opening reached so far [L]
  double mixity = 0;   ///< M when the damage grew last
  double slip = 0;     ///< s [L]
  Vec2 opening{0, 0};  ///< q at the last accepted step, of joints with friction [L]

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("kappa", dimension::length, self.kappa);
    visit("mixity", dimension::none, self.mixity);
    visit("slip", dimension::length, self.slip);
    visit("opening", dimension::length, self.opening);
  }
};

Memory memory_of(const History& h) { return h.memory.as<Memory>(); }

/// dy/dω of the compliance y = ω/g; infinite where the traction has vanished.
double compliance_slope(const SofteningShape& shape, double omega) {
  const double g = shape.value(omega);
  return (g - omega * shape.slope(omega)) / (g * g);
}

}  // namespace

DamageLaw::DamageLaw(const SofteningNumbers& numbers, std::unique_ptr<SofteningShape> shape)
    : n_(numbers),
      shape_(std::move(shape)),
      scale_(numbers.fracture_energy / numbers.strength),
      m_(numbers.friction / (numbers.shear_weight * numbers.shear_weight)) {}

std::vector<Remembered> DamageLaw::memory() const { return declared<Memory>(); }

double DamageLaw::kappa(const History& h, double k) const {
  return std::max(memory_of(h).kappa, initial_kappa(k));
}

double DamageLaw::steepest_slope() const {
  return shape_->steepest() * n_.strength * n_.strength /
         std::min(n_.fracture_energy, n_.shear_fracture_energy);
}

double DamageLaw::energy_ratio(double mixity) const {
  return 1 + (n_.shear_fracture_energy / n_.fracture_energy - 1) * std::pow(mixity, n_.mixed_mode_exponent);
}

double DamageLaw::energy_ratio_slope(double mixity) const {
  return (n_.shear_fracture_energy / n_.fracture_energy - 1) * n_.mixed_mode_exponent *
         std::pow(mixity, n_.mixed_mode_exponent - 1);
}

DamageLaw::Trial DamageLaw::trial(const Sides& sides) const {
  const Vec2& q = sides.q;
  const double beta = n_.shear_weight, normal = std::max(q.x(), 0.0);
  Trial out;
  Vec2 sliding_gradient(0, 1);
  double sliding = q.y();
  if (sides.closing > 0 && m_ > 0) {
    const double excess = std::abs(q.y()) - m_ * sides.closing, sign = q.y() < 0 ? -1 : 1;
    sliding = sign * std::max(excess, 0.0);
    sliding_gradient = excess > 0 ? Vec2(-sign * m_ * sides.per_normal, 1) : Vec2(Vec2::Zero());
  }
  out.opening = std::hypot(normal, beta * sliding);
  if (out.opening == 0) return out;
  out.opening_gradient =
      Vec2(normal, 0) / out.opening + beta * beta * sliding / out.opening * sliding_gradient;
  if (!has_modes()) return out;
  const double square = out.opening * out.opening, shear = beta * sliding;
  out.mixity = shear * shear / square;
  if (normal > 0)
    out.mixity_gradient = 2 * beta * beta * normal * sliding / (square * square) * Vec2(-sliding, normal);
  return out;
}

DamageLaw::Equivalent DamageLaw::equivalent(const Sides& sides, double k) const {
  const Trial at = trial(sides);
  Equivalent out{at.opening, at.mixity, at.opening_gradient, at.mixity_gradient};
  const double kappa0 = initial_kappa(k);
  if (at.opening < kappa0 * (1 - on_surface) || !has_modes() || at.mixity == 0) return out;
  // κ has a corner at κ0: what stands on the surface within rounding goes on beyond it.
  const double ratio = energy_ratio(at.mixity), ratio_slope = energy_ratio_slope(at.mixity);
  const double omega = shape_->at_trial_opening(std::max(at.opening, kappa0), ratio * scale_, kappa0);
  if (shape_->value(omega) <= 0) {
    out.kappa = at.opening / ratio;
    out.gradient = (at.opening_gradient - out.kappa * ratio_slope * at.mixity_gradient) / ratio;
    return out;
  }
  const double mode_one = shape_->at_same_compliance(omega, ratio);
  if (at.opening > kappa0) out.kappa = scale_ * mode_one + kappa0 * shape_->value(mode_one);
  const double rise = ratio * scale_ + kappa0 * shape_->slope(omega);
  const Vec2 omega_gradient =
      (at.opening_gradient - scale_ * omega * ratio_slope * at.mixity_gradient) / rise;
  const Vec2 compliance_gradient = ratio * compliance_slope(*shape_, omega) * omega_gradient +
                                   omega / shape_->value(omega) * ratio_slope * at.mixity_gradient;
  out.gradient =
      (scale_ + kappa0 * shape_->slope(mode_one)) / compliance_slope(*shape_, mode_one) * compliance_gradient;
  return out;
}

double DamageLaw::next_corner(const History& h, double k) const {
  const double omega = shape_->next_corner(omega_at(kappa(h, k), k));
  return std::isfinite(omega) ? scale_ * omega + initial_kappa(k) * shape_->value(omega) : omega;
}

double DamageLaw::equivalent_opening(const Vec2& q, const History&, double k) const {
  return equivalent(q, k).kappa;
}

Vec2 DamageLaw::opening_gradient(const Vec2& q, const History&, double k) const {
  return equivalent(q, k).gradient;
}

double DamageLaw::secant_at(double kappa, double k) const {
  return kappa > initial_kappa(k) ? n_.strength * shape_->value(omega_at(kappa, k)) / kappa : k;
}

double DamageLaw::secant_slope_at(double kappa, double k) const {
  const double omega = omega_at(kappa, k), slope = shape_->slope(omega);
  const double strength_slope = n_.strength * slope / (scale_ + initial_kappa(k) * slope);
  return (strength_slope - n_.strength * shape_->value(omega) / kappa) / kappa;
}

Friction DamageLaw::friction(const Sides& at, const History& h) const {
  return coulomb_friction(at, memory_of(h).slip, h.sliding, m_);
}

Vec2 DamageLaw::slip_gradient(const Vec2& q, const History& h, double k) const {
  if (kappa(h, k) <= initial_kappa(k)) return Vec2::Zero();
  const Friction held = friction(q, h);
  return held.at_limit ? Vec2(m_, held.direction) : Vec2(Vec2::Zero());
}

Response DamageLaw::secant(const Sides& sides, const History& h, double kappa, double k) const {
  const Vec2& q = sides.q;
  const double beta2 = n_.shear_weight * n_.shear_weight;
  const double r = secant_at(kappa, k);
  Response out;
  out.tangent.diagonal() = Vec2(q.x() < 0 ? k : r, beta2 * r);
  out.traction = out.tangent.diagonal().cwiseProduct(q);
  if (r == k || m_ == 0 || !sides.rub()) return out;
  const Friction held = friction(sides, h);
  out.traction.y() += beta2 * (k - r) * held.elastic;
  out.tangent.row(1) += beta2 * (k - r) * held.gradient.transpose();
  return out;
}

/// A point on its surface is loading when the path has chosen so: the flag decides within round-off of κ.
bool DamageLaw::is_loading(double opening, double kappa, bool flag) const {
  constexpr double round_off = 1e-11;
  return flag ? opening >= kappa * (1 - on_surface) : opening > kappa * (1 + round_off);
}

Response DamageLaw::respond(const Vec2& q, const History& h, double k) const { return responded(q, h, k); }

Response DamageLaw::respond_bounded(const Vec2& q, const History& h, double k, double closing) const {
  return responded({q, closing}, h, k);
}

Response DamageLaw::responded(const Sides& sides, const History& h, double k) const {
  const Vec2& q = sides.q;
  const double reached = kappa(h, k);
  const Equivalent at = equivalent(sides, k);
  if (!is_loading(at.kappa, reached, h.loading)) return secant(sides, h, std::max(reached, at.kappa), k);
  const double kappa = std::max(at.kappa, reached);
  Response out = secant(sides, h, kappa, k);
  const double beta2 = n_.shear_weight * n_.shear_weight;
  const Vec2 lever(std::max(q.x(), 0.0), beta2 * (q.y() - friction(sides, h).elastic));
  out.tangent += secant_slope_at(kappa, k) * lever * at.gradient.transpose();
  return out;
}

Response DamageLaw::respond_frozen(const Vec2& q, const History& h, double k) const {
  return secant(q, h, kappa(h, k), k);
}

DamageLaw::Spent DamageLaw::spent(double kappa, double mixity, double k) const {
  const double kappa0 = initial_kappa(k);
  if (kappa < kappa0) return {};
  const double mode_one = omega_at(kappa, k), ratio = has_modes() ? energy_ratio(mixity) : 1;
  const double omega = ratio == 1 ? mode_one : shape_->at_same_compliance(mode_one, 1 / ratio);
  const double g = shape_->value(omega), slope = shape_->slope(omega), spent = shape_->spent(omega);
  Spent out{.value = n_.fracture_energy * ratio * spent, .per_kappa = 0, .per_mixity = 0};
  if (has_modes())
    out.per_mixity = n_.fracture_energy * energy_ratio_slope(mixity) * (spent - 0.5 * omega * g);
  if (g <= 0) return out;
  const double stretch =
      ratio == 1 ? 1 : compliance_slope(*shape_, mode_one) / (ratio * compliance_slope(*shape_, omega));
  out.per_kappa = n_.fracture_energy * ratio * 0.5 * (g - omega * slope) * stretch /
                  (scale_ + kappa0 * shape_->slope(mode_one));
  if (has_modes())
    out.per_mixity = n_.fracture_energy * energy_ratio_slope(mixity) * (spent - 0.5 * omega * g);
  return out;
}

/// Energy of the damage growing from one κ to another: the mean of the modes in which it grew last and grows
/// now.
double DamageLaw::growth_energy(const Growth& kappa, double mixity, const History& h, double k) const {
  const auto [from, to] = kappa;
  const auto at = [&](double mode) { return spent(to, mode, k).value - spent(from, mode, k).value; };
  if (!has_modes() || from <= initial_kappa(k)) return at(mixity);
  return 0.5 * (at(memory_of(h).mixity) + at(mixity));
}

Spending DamageLaw::spending(const Vec2& q, const History& h, double k) const {
  const Equivalent at = equivalent(q, k);
  const double reached = kappa(h, k), now = std::max(reached, at.kappa), kappa0 = initial_kappa(k);
  const bool loads = is_loading(at.kappa, reached, h.loading);
  Spending out;
  if (now > reached) out.value = growth_energy({reached, now}, at.mixity, h, k);
  if (loads) {
    const Spent here = spent(now, at.mixity, k);
    const bool averaged = has_modes() && reached > kappa0;
    const double old_mode = averaged ? spent(now, memory_of(h).mixity, k).per_kappa : here.per_kappa;
    const double of_mixity = has_modes() ? here.per_mixity - spent(reached, at.mixity, k).per_mixity : 0;
    out.gradient = 0.5 * (here.per_kappa + old_mode) * at.gradient +
                   (averaged ? 0.5 : 1) * of_mixity * at.mixity_gradient;
  }
  if (m_ == 0 || (now <= kappa0 && !loads)) return out;
  add_friction_work(q, h, k, out);
  return out;
}

/// ∫ β² k e d(damage s) with the mean e of where the step slides, or of both ends where it sticks; nothing
/// where that would gain energy. At the start of a step the derivative is that of going on.
void DamageLaw::add_friction_work(const Vec2& q, const History& h, double k, Spending& out) const {
  const Equivalent at = equivalent(q, k);
  const double reached = kappa(h, k), now = std::max(reached, at.kappa);
  const double stiffness = n_.shear_weight * n_.shear_weight * k;
  const Friction held = friction(q, h);
  const Memory start = memory_of(h);
  const LineSlide slid = slide_along(start.opening, q, start.slip, m_);
  const double before = friction(start.opening, h).elastic;
  const double mean = slid.energy > 0 ? slid.mean : 0.5 * (before + held.elastic);
  const Vec2 mean_gradient = slid.energy > 0 ? slid.mean_gradient : Vec2(0.5 * held.gradient);
  const double damaged = damage_at(now, k), slip = q.y() - held.elastic;
  const bool starts = q == start.opening;
  const double slipped = starts ? 0 : damaged * slip - damage_at(reached, k) * start.slip;
  const double onward = held.slides ? held.elastic : slip;
  if (mean * (starts ? onward : slipped) <= 0) return;
  out.value += stiffness * mean * slipped;
  Vec2 slipped_gradient = damaged * (Vec2(0, 1) - held.gradient);
  if (is_loading(at.kappa, reached, h.loading))
    slipped_gradient -= slip * secant_slope_at(now, k) / k * at.gradient;
  out.gradient += stiffness * (slipped * mean_gradient + mean * slipped_gradient);
}

History DamageLaw::accept(const Vec2& q, const History& h, double k) const {
  const Equivalent at = equivalent(q, k);
  const double reached = kappa(h, k);
  History out = h;
  Memory next = memory_of(h);
  out.dissipated += spending(q, h, k).value;
  out.loading = at.kappa >= reached * (1 - on_surface);
  if (at.kappa > reached) next.kappa = at.kappa;
  // Points that rupture together do so within the rounding of an equilibrium.
  if (const double end = rupture_kappa(k); out.loading && next.kappa > end * (1 - together))
    next.kappa = std::max(next.kappa, end);
  if (at.kappa > 0) next.mixity = at.mixity;
  if (m_ > 0) {
    const Friction held = friction(q, h);
    const bool damaged = next.kappa > initial_kappa(k);
    next.opening = q;
    next.slip = damaged ? q.y() - held.elastic : 0;
    out.sliding = damaged && held.at_limit;
  }
  out.memory.keep(next);
  return out;
}

double DamageLaw::stored(const Vec2& q, const History& h, double k) const {
  const double beta2 = n_.shear_weight * n_.shear_weight,
               r = secant_at(std::max(kappa(h, k), equivalent(q, k).kappa), k);
  const double normal = q.x() < 0 ? k : r;
  double out = 0.5 * (normal * q.x() * q.x() + r * beta2 * q.y() * q.y());
  if (m_ > 0 && r < k) out += 0.5 * (k - r) * beta2 * std::pow(friction(q, h).elastic, 2);
  return out;
}

std::optional<Contact> DamageLaw::contact(const History& h, double k) const {
  const double reached = kappa(h, k);
  if (reached <= initial_kappa(k)) return {};
  const double beta2 = n_.shear_weight * n_.shear_weight, r = secant_at(reached, k);
  return Contact{.closed = k,
                 .open = r,
                 .shear = beta2 * r,
                 .friction = m_ > 0 ? beta2 * (k - r) : 0,
                 .coefficient = m_,
                 .slip = memory_of(h).slip};
}

/// κ = w + t_eq/k.
std::optional<Widening> DamageLaw::widening(double kappa, double k) const {
  const double kappa0 = initial_kappa(k), omega = kappa > kappa0 ? omega_at(kappa, k) : 0;
  return Widening{.opening = scale_ * omega,
                  .slope = scale_ / (scale_ + kappa0 * shape_->slope(omega)),
                  .gain = largest_gain()};
}

/// κ is at most q_eq/ρ: ∂κ/∂q_n ≤ (1 + 2 M ρ'/ρ)/ρ with M ρ' = η (ρ − 1) where it is open, and β m/ρ where it slides closed.
double DamageLaw::largest_gain() const {
  const double sliding = std::max(1.0, n_.shear_weight * m_);
  if (!has_modes()) return sliding;
  return n_.shear_fracture_energy > n_.fracture_energy
             ? std::max(sliding, 1 + 2 * n_.mixed_mode_exponent)
             : sliding * n_.fracture_energy / n_.shear_fracture_energy;
}

History DamageLaw::grown(const History& h, double k, double factor) const {
  History out = h;
  Memory next = memory_of(h);
  const double from = kappa(h, k);
  next.kappa = std::min(factor * from, rupture_kappa(k));
  out.memory.keep(next);
  out.dissipated += growth_energy({from, next.kappa}, next.mixity, h, k);
  return out;
}

unsigned DamageLaw::piece(const Vec2& q, const History& h, double k) const {
  const double reached = kappa(h, k), opening = equivalent(q, k).kappa;
  const bool damaged = reached > initial_kappa(k);
  const Friction held = friction(q, h);
  const unsigned sliding = damaged && held.slides ? (held.direction < 0 ? 16u : 8u) : 0u;
  return (opening > reached ? 1u : 0u) + (damaged && q.x() < 0 ? 2u : 0u) +
         (opening >= rupture_kappa(k) ? 4u : 0u) + sliding;
}

}  // namespace dda
