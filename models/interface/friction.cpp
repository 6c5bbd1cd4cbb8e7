#include <cmath>
#include <limits>
#include <numbers>

#include "models/interface/coulomb.hpp"
#include "models/interface/law.hpp"

namespace dda {
namespace {

struct FrictionParameters {
  double friction_angle = 0;
};

struct Memory {
  double slip = 0;     ///< s [L]
  Vec2 opening{0, 0};  ///< q at the last accepted step [L]

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("slip", dimension::length, self.slip);
    visit("opening", dimension::length, self.opening);
  }
};

/// Contact of separate bodies: no tension, Coulomb friction under pressure, closed again whenever it meets.
///
///     t_n = k min(q_n, 0),   t_s = k e,   e = clip(q_s − s, ± tan φ ⟨−q_n⟩)
///
/// Closed and sticking counts as intact: P = k diag(1, 1).
class ContactFriction final : public InterfaceLaw {
 public:
  explicit ContactFriction(double m) : m_(m) {}

  std::vector<Remembered> memory() const override { return declared<Memory>(); }
  bool can_crack() const override { return true; }
  double initial_kappa(double) const override { return std::numeric_limits<double>::infinity(); }
  double rupture_kappa(double) const override { return std::numeric_limits<double>::infinity(); }
  double equivalent_opening(const Vec2&, const History&, double) const override { return 0; }
  Vec2 opening_gradient(const Vec2&, const History&, double) const override { return Vec2::Zero(); }
  Vec2 slip_gradient(const Vec2& q, const History& h, double) const override {
    const Friction held = friction(q, h);
    return held.at_limit ? Vec2(m_, held.direction) : Vec2(Vec2::Zero());
  }

  Response respond(const Vec2& q, const History& h, double k) const override { return responded(q, h, k); }
  Response respond_bounded(const Vec2& q, const History& h, double k, double closing) const override {
    return responded({q, closing}, h, k);
  }
  Response respond_frozen(const Vec2& q, const History& h, double k) const override {
    return respond(q, h, k);
  }

  Spending spending(const Vec2& q, const History& h, double k) const override {
    const auto [slip, from] = h.memory.as<Memory>();
    const LineSlide slid = h.sliding && q == from ? slide_on(q, slip, m_) : slide_along(from, q, slip, m_);
    return {k * slid.energy, k * slid.gradient};
  }
  History accept(const Vec2& q, const History& h, double k) const override {
    const Friction held = friction(q, h);
    History out = h;
    out.dissipated += spending(q, h, k).value;
    out.memory.keep(Memory{.slip = q.y() - held.elastic, .opening = q});
    out.sliding = held.at_limit;
    return out;
  }
  std::optional<Contact> contact(const History& h, double k) const override {
    return Contact{.closed = k, .friction = k, .coefficient = m_, .slip = h.memory.as<Memory>().slip};
  }
  double stored(const Vec2& q, const History& h, double k) const override {
    return q.x() >= 0 ? 0 : 0.5 * k * (q.x() * q.x() + std::pow(friction(q, h).elastic, 2));
  }
  std::optional<double> residual_friction() const override { return m_; }
  double damage(const History&, double) const override { return 1; }
  unsigned piece(const Vec2& q, const History& h, double) const override {
    if (q.x() > 0) return 1;
    const Friction held = friction(q, h);
    if (m_ == 0) return 2;
    return !held.slides ? 0 : held.direction < 0 ? 4 : 2;
  }

 private:
  Friction friction(const Sides& at, const History& h) const {
    return coulomb_friction(at, h.memory.as<Memory>().slip, h.sliding, m_);
  }
  Response responded(const Sides& at, const History& h, double k) const {
    const Friction held = friction(at, h);
    const bool is_closed = at.q.x() <= 0;
    Response out{k * Vec2(std::min(at.q.x(), 0.0), held.elastic), Mat2::Zero()};
    out.tangent << (is_closed ? k : 0), 0, k * held.gradient.x(), k * held.gradient.y();
    return out;
  }
  double m_;
};

Schema<FrictionParameters> schema() {
  using P = FrictionParameters;
  return Schema<P>("Contact of separate bodies: no tension, Coulomb friction when closed.")
      .number("friction_angle", &P::friction_angle,
              {.fallback = 0.0,
               .bounds = at_least(0) & below(90),
               .text = "Friction angle in degrees; 0 slides freely."});
}

std::unique_ptr<InterfaceLaw> make(const FrictionParameters& p) {
  return std::make_unique<ContactFriction>(std::tan(p.friction_angle * std::numbers::pi / 180));
}

}  // namespace

DDA_REGISTER(interface_laws(), "friction", schema(), make);

}  // namespace dda
