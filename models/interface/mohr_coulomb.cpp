#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "models/interface/coulomb.hpp"
#include "models/interface/law.hpp"

namespace dda {
namespace {

struct MohrCoulombParameters {
  double tensile_strength = 0;
  double cohesion = 0;
  double friction_angle = 0;
  std::optional<double> residual_friction_angle;
};

/// What has been released of a point: nothing, its cohesion, all of it.
enum Phase : int { bonded, sheared, torn };

struct Memory {
  int phase = bonded;
  double slip = 0;     ///< s [L]
  double opened = 0;   ///< w [L]
  Vec2 opening{0, 0};  ///< q at the last accepted step [L]
  Vec2 held{0, 0};     ///< traction at the beginning of a release [F/L²]
  Vec2 limit{0, 0};    ///< what t is limited to at the last accepted step while it is released [F/L²]

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("phase", dimension::none, self.phase);
    visit("slip", dimension::length, self.slip);
    visit("opened", dimension::length, self.opened);
    visit("opening", dimension::length, self.opening);
    visit("held", dimension::stress, self.held);
    visit("limit", dimension::stress, self.limit);
  }
};

Memory memory_of(const History& h) { return h.memory.as<Memory>(); }

double tangent_of(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

/// Mohr-Coulomb with tension cut-off and instantaneous release, in terms of the point's stress resultants.
///
///     t_n ≤ ft,   |t_s| ≤ c − t_n tan φ
///     phase 0, sliding not allowed:  t = P q, P = k diag(1, 1)
///     phase 1, sliding allowed:      no penetration, limited tension t_n = k q_n ≤ ft, t_s by friction
///     phase 2, open:                 no tension, friction when closed again
///
/// While a point is released (share a from 1 to 0) it is elastic within limits that shrink, and slides or
/// opens at them; s is its slip, w what it has opened by:
///
///     phase 1:  t_n = k q_n ≤ ft,   |t_s| ≤ a ⟨c − t_n tan φ⟩ + (1 − a) tan φ_r ⟨−t_n⟩
///     phase 2:  t_n = min(k ⟨q_n − w⟩, a t_n,held) − k ⟨−q_n⟩
///               |t_s| ≤ a |t_s,held| + (1 − a) tan φ_r ⟨−t_n⟩
///     both:     t_s = k e,   e = q_s − s within the limit
///
/// With a = 0 these are contact and friction. Where t_n reaches ft in phase 1 phase 2 begins. Spent is
/// traction times what slides and opens, ∫ t · dw ≥ 0, exact on the line of a step on which openings and
/// limits run straight. The release itself, which holds q and frees the load, is
/// continuation/detour/release.hpp. Its energy is that of the trial spring, so it depends on the size of the
/// blocks. Source: Pearce et al. (2000), sections 3 and 5.
class MohrCoulomb final : public InterfaceLaw {
 public:
  explicit MohrCoulomb(const MohrCoulombParameters& p)
      : ft_(p.tensile_strength),
        c_(p.cohesion),
        tan_(tangent_of(p.friction_angle)),
        residual_(tangent_of(p.residual_friction_angle.value_or(p.friction_angle))) {}

  std::vector<Remembered> memory() const override { return declared<Memory>(); }
  bool can_crack() const override { return true; }
  bool releases_at_once() const override { return true; }
  double initial_kappa(double k) const override { return ft_ / k; }
  /// |q_s| + q_n tan φ ≤ √(q_n² + q_s²)/cos φ.
  double intact_bound(const History& h, double k) const override {
    return memory_of(h).phase == bonded ? std::min(ft_, c_ / std::hypot(1, tan_)) / k : 0;
  }
  double rupture_kappa(double) const override { return std::numeric_limits<double>::infinity(); }
  bool is_broken(const History& h, double) const override { return memory_of(h).phase == torn; }
  double equivalent_opening(const Vec2& q, const History& h, double) const override {
    return std::max(0.0, nearest(q, h).opening);
  }
  Vec2 opening_gradient(const Vec2& q, const History& h, double) const override {
    const Nearest at = nearest(q, h);
    return at.opening > 0 ? at.gradient : Vec2(Vec2::Zero());
  }
  Vec2 slip_gradient(const Vec2& q, const History& h, double) const override {
    if (memory_of(h).phase == bonded || h.share > 0) return Vec2::Zero();
    const Friction held = friction(q, h);
    return held.at_limit ? Vec2(residual_, held.direction) : Vec2(Vec2::Zero());
  }

  Response respond(const Vec2& q, const History& h, double k) const override {
    if (memory_of(h).phase == bonded) return {k * q, k * Mat2::Identity()};
    return h.share > 0 ? releasing(q, h, k) : released(q, h, k);
  }
  Response respond_frozen(const Vec2& q, const History& h, double k) const override {
    return respond(q, h, k);
  }
  Response respond_bounded(const Vec2& q, const History& h, double k, double closing) const override {
    return memory_of(h).phase == bonded || h.share > 0 ? respond(q, h, k) : released({q, closing}, h, k);
  }

  Spending spending(const Vec2& q, const History& h, double k) const override {
    const Memory start = memory_of(h);
    if (start.phase == bonded) return {};
    if (h.share == 0 && start.limit.isZero(0)) {
      const LineSlide slid = h.sliding && q == start.opening
                                 ? slide_on(q, start.slip, residual_)
                                 : slide_along(start.opening, q, start.slip, residual_);
      return {k * slid.energy, k * slid.gradient};
    }
    const Limits now = limits(q, h, k);
    const LimitedSlide slid = slide_under({start.limit.y(), now.shear},
                                          {k * (start.opening.y() - start.slip), k * (q.y() - start.slip)});
    Spending out{slid.energy / k, Vec2(slid.per_limit * now.per_normal / k, slid.per_trial)};
    const Course opening{k * (start.opening.x() - start.opened), k * (q.x() - start.opened)};
    if (start.phase == sheared || opening.to <= 0) return out;
    const LimitedSlide tearing = slide_under({start.limit.x(), now.tension}, opening);
    out.value += tearing.energy / k;
    out.gradient.x() += tearing.per_trial;
    return out;
  }
  History accept(const Vec2& q, const History& h, double k) const override {
    constexpr double round_off = 1e-10;
    Memory next = memory_of(h);
    History out = h;
    out.dissipated += spending(q, h, k).value;
    out.loading = next.phase != torn && equivalent_opening(q, h, k) >= initial_kappa(k) * (1 - round_off);
    next.opening = q;
    if (next.phase != bonded && h.share > 0)
      move_limits(q, h, k, next);
    else if (next.phase != bonded) {
      const Friction held = friction(q, h);
      next.limit.setZero();
      next.slip = q.y() - held.elastic;
      out.sliding = held.at_limit;
    }
    out.memory.keep(next);
    return out;
  }
  /// Of what is released: tension up to ft while only cohesion is lost, none afterwards.
  std::optional<Contact> contact(const History& h, double k) const override {
    const Memory own = memory_of(h);
    if (own.phase == bonded || h.share > 0) return {};
    return Contact{.closed = k,
                   .open = own.phase == sheared ? k : 0,
                   .friction = k,
                   .coefficient = residual_,
                   .slip = own.slip};
  }
  double stored(const Vec2& q, const History& h, double k) const override {
    return respond(q, h, k).traction.squaredNorm() / (2 * k);
  }
  std::optional<double> residual_friction() const override { return residual_; }
  double damage(const History& h, double) const override { return 0.5 * memory_of(h).phase; }
  unsigned piece(const Vec2& q, const History& h, double) const override {
    if (memory_of(h).phase == bonded) return 0;
    const Friction held = friction(q, h);
    return (q.x() < 0 ? 1u : 2u) + (!held.slides ? 0u : held.direction < 0 ? 8u : 4u);
  }

  History release(const Vec2& q, const History& h, double k, double share) const override {
    History out = h;
    if (h.share == 0 || h.loading) {
      Memory next = memory_of(h);
      next.held = respond(q, h, k).traction;
      next.phase = fails_in_tension(q, h) ? torn : sheared;
      out.share = 1;
      out.memory.keep(next);
      const Limits now = limits(q, out, k);
      next.limit = {now.tension, std::max(now.shear, std::abs(next.held.y()))};
      out.memory.keep(next);
    }
    out.share = share;
    out.loading = out.sliding = false;
    return out;
  }
  Vec2 held_direction(const Vec2& q, const History& h) const override {
    const Memory own = memory_of(h);
    return own.phase == sheared && h.share > 0 ? Vec2(0, q.y() < own.slip ? -1 : 1) : Vec2(1, 0);
  }

 private:
  struct Nearest {
    double opening;
    Vec2 gradient;
  };
  /// ft/k times the larger of t_n/ft and (|t_s| + t_n tan φ)/c.
  Nearest nearest(const Vec2& q, const History& h) const {
    const int phase = memory_of(h).phase;
    if (phase == torn) return {0, Vec2::Zero()};
    const Nearest tension{q.x(), Vec2(1, 0)};
    if (phase == sheared) return tension;
    const double scale = ft_ / c_, sign = q.y() < 0 ? -1 : 1;
    const Nearest shear{scale * (std::abs(q.y()) + tan_ * q.x()), scale * Vec2(tan_, sign)};
    return shear.opening > tension.opening ? shear : tension;
  }
  bool fails_in_tension(const Vec2& q, const History& h) const {
    return memory_of(h).phase == sheared || ft_ / c_ * (std::abs(q.y()) + tan_ * q.x()) <= q.x();
  }
  Friction friction(const Sides& at, const History& h) const {
    return coulomb_friction(at, memory_of(h).slip, h.sliding, residual_);
  }
  /// Of the tractions of what is released, and the derivative of the second one with respect to q_n.
  struct Limits {
    double tension, shear, per_normal;
  };
  Limits limits(const Vec2& q, const History& h, double k) const {
    const Memory own = memory_of(h);
    const double a = h.share, bond = c_ - tan_ * k * q.x(), pressure = k * std::max(-q.x(), 0.0);
    const bool bonds = own.phase == sheared && bond > 0;
    const double lost = own.phase == torn ? std::abs(own.held.y()) : std::max(bond, 0.0);
    const double per_pressure = q.x() < 0 ? -(1 - a) * residual_ * k : 0;
    return {own.phase == torn ? a * std::max(own.held.x(), 0.0) : ft_,
            a * lost + (1 - a) * residual_ * pressure, per_pressure - (bonds ? a * tan_ * k : 0)};
  }
  /// What a point that is being released remembers after q: its limits, and what has slid and opened.
  void move_limits(const Vec2& q, const History& h, double k, Memory& next) const {
    const Limits now = limits(q, h, k);
    const Vec2 traction = respond(q, h, k).traction;
    next.limit = {now.tension, now.shear};
    next.slip = q.y() - traction.y() / k;
    if (next.phase == torn) next.opened = std::max(next.opened, q.x() - traction.x() / k);
  }
  Response releasing(const Vec2& q, const History& h, double k) const {
    Response out{Vec2(k * q.x(), 0), Vec2(k, 0).asDiagonal()};
    const Memory own = memory_of(h);
    const Limits most = limits(q, h, k);
    if (own.phase == torn && q.x() > 0) {
      const double trial = k * (q.x() - own.opened);
      out.traction.x() = std::clamp(trial, 0.0, most.tension);
      out.tangent(0, 0) = trial > 0 && trial < most.tension ? k : 0;
    }
    const double trial = k * (q.y() - own.slip), sign = trial < 0 ? -1 : 1;
    if (std::abs(trial) <= most.shear) {
      out.traction.y() = trial;
      out.tangent(1, 1) = k;
    } else {
      out.traction.y() = sign * most.shear;
      out.tangent(1, 0) = sign * most.per_normal;
    }
    return out;
  }
  Response released(const Sides& at, const History& h, double k) const {
    const Friction held = friction(at, h);
    const bool bears = at.q.x() <= 0 || memory_of(h).phase == sheared;
    Response out{k * Vec2(bears ? at.q.x() : 0, held.elastic), Mat2::Zero()};
    out.tangent << (bears ? k : 0), 0, k * held.gradient.x(), k * held.gradient.y();
    return out;
  }

  double ft_, c_, tan_, residual_;
};

Schema<MohrCoulombParameters> schema() {
  using P = MohrCoulombParameters;
  return Schema<P>(
             "Mohr-Coulomb with tension cut-off; what fails is released at once and leaves friction. Not for "
             "joints with multipliers (lagrange, augmented_lagrangian).")
      .number("tensile_strength", &P::tensile_strength,
              {.dimension = dimension::stress, .bounds = above(0), .text = "Tension cut-off ft."})
      .number("cohesion", &P::cohesion,
              {.dimension = dimension::stress,
               .bounds = above(0),
               .text = "Shear strength c without normal traction."})
      .number("friction_angle", &P::friction_angle,
              {.fallback = 0.0,
               .bounds = at_least(0) & below(90),
               .text = "Friction angle of the bond in degrees."})
      .number("residual_friction_angle", &P::residual_friction_angle,
              {.bounds = at_least(0) & below(90),
               .text = "Friction angle of what is released, in degrees; that of the bond if absent."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.residual_friction_angle.value_or(0) > p.friction_angle)
          findings.add(
              where,
              "`residual_friction_angle` exceeds `friction_angle`: releasing the bond would strengthen it");
      });
}

}  // namespace

DDA_REGISTER(interface_laws(), "mohr_coulomb", schema(), make_of<MohrCoulomb>);

}  // namespace dda
