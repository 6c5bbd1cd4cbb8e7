#include "models/interface/water_filled_law.hpp"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

/// Share of κ within which a point stands on its surface; the flag of its history says which way it leaves.
constexpr double upon_surface = 1e-10;

/// What the water remembers, behind what the law of the solid does.
struct WaterMemory {
  double shift = 0;    ///< c [L]
  double opening = 0;  ///< w_n at the last accepted step [L]
  double work = 0;     ///< ∫ P dw_n [F/L]

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("water_shift", dimension::length, self.shift);
    visit("water_opening", dimension::length, self.opening);
    visit("water_work", dimension::energy_per_area, self.work);
  }
};

std::size_t size_of(const std::vector<Remembered>& memory) {
  std::size_t out = 0;
  for (const Remembered& part : memory) out += static_cast<std::size_t>(part.size);
  return out;
}

}  // namespace

WaterFilledLaw::WaterFilledLaw(std::shared_ptr<const InterfaceLaw> law, double pressure, double opening)
    : law_(std::move(law)),
      is_crack_(law_->widening(0, 1).has_value()),
      full_(pressure),
      opening_(opening),
      behind_(size_of(law_->memory())) {}

std::vector<Remembered> WaterFilledLaw::memory() const {
  std::vector<Remembered> out = law_->memory();
  for (const Remembered& part : declared<WaterMemory>()) out.push_back(part);
  return out;
}

WaterFilledLaw::Shift WaterFilledLaw::frozen(const History& h, double k) const {
  if (!is_crack_) return {full_ / k, Vec2::Zero()};
  return {h.memory.as<WaterMemory>(behind_).shift, Vec2::Zero()};
}

WaterFilledLaw::Filling WaterFilledLaw::at(double kappa, double k) const {
  const Widening wide = *law_->widening(kappa, k);
  if (wide.opening >= opening_) return {full_, 0};
  return {full_ * std::max(wide.opening, 0.0) / opening_, full_ / opening_ * wide.slope};
}

/// c by Newton's method within its bounds: at c the water presses less than p s(κ), at p/k no less.
double WaterFilledLaw::solved(const Vec2& q, const History& h, double k, double least) const {
  double low = least, high = full_ / k, c = least;
  constexpr int most = 60;
  for (int i = 0; i < most && high > low; ++i) {
    const Vec2 seen(q.x() + c, q.y());
    const Filling now = at(std::max(law_->equivalent_opening(seen, h, k), kappa(h, k)), k);
    const double rest = c - now.pressure / k;
    (rest < 0 ? low : high) = c;
    if (rest == 0) return c;
    const double rise = 1 - now.slope / k * law_->opening_gradient(seen, h, k).x();
    const double next = c - rest / rise;
    if (std::abs(next - c) <= 4e-16 * std::abs(seen.x())) return std::clamp(next, low, high);
    c = next > low && next < high ? next : 0.5 * (low + high);
  }
  return c;
}

WaterFilledLaw::Shift WaterFilledLaw::shift(const Vec2& q, const History& h, double k) const {
  if (!is_crack_) return frozen(h, k);
  const double reached = kappa(h, k);
  Shift out = frozen(h, k);
  double opening = law_->equivalent_opening(out.of(q), h, k);
  if (opening < reached * (1 - upon_surface) || (opening <= reached && !h.loading)) return out;
  if (opening > reached) {
    out.c = solved(q, h, k, out.c);
    opening = law_->equivalent_opening(out.of(q), h, k);
  }
  const Vec2 a = law_->opening_gradient(out.of(q), h, k);
  const double b = at(std::max(opening, reached), k).slope / k;
  out.gradient = b / (1 - b * a.x()) * a;
  return out;
}

/// The one at which the water is whole is a corner, too.
double WaterFilledLaw::next_corner(const History& h, double k) const {
  if (!is_crack_) return law_->next_corner(h, k);
  const double corner = law_->next_corner(h, k), reached = kappa(h, k);
  const Widening wide = *law_->widening(reached, k);
  if (wide.opening >= opening_) return corner;
  double low = reached, high = std::isfinite(corner) ? corner : 2 * reached + 2 * opening_;
  if (law_->widening(high, k)->opening <= opening_) return corner;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (law_->widening(middle, k)->opening < opening_ ? low : high) = middle;
  }
  return high;
}

double WaterFilledLaw::equivalent_opening(const Vec2& q, const History& h, double k) const {
  return law_->equivalent_opening(shift(q, h, k).of(q), h, k);
}

Vec2 WaterFilledLaw::opening_gradient(const Vec2& q, const History& h, double k) const {
  const Shift water = shift(q, h, k);
  return water.chained(law_->opening_gradient(water.of(q), h, k));
}

Vec2 WaterFilledLaw::slip_gradient(const Vec2& q, const History& h, double k) const {
  const Shift water = shift(q, h, k);
  return water.chained(law_->slip_gradient(water.of(q), h, k));
}

Response WaterFilledLaw::respond(const Vec2& q, const History& h, double k) const {
  const Shift water = shift(q, h, k);
  Response out = law_->respond(water.of(q), h, k);
  out.traction.x() -= k * water.c;
  out.tangent += (out.tangent.col(0) - Vec2(k, 0)) * water.gradient.transpose();
  return out;
}

Response WaterFilledLaw::respond_frozen(const Vec2& q, const History& h, double k) const {
  const Shift water = frozen(h, k);
  Response out = law_->respond_frozen(water.of(q), h, k);
  out.traction.x() -= k * water.c;
  return out;
}

Spending WaterFilledLaw::spending(const Vec2& q, const History& h, double k) const {
  const Shift water = shift(q, h, k);
  const Spending of_solid = law_->spending(water.of(q), h, k);
  return {of_solid.value, water.chained(of_solid.gradient)};
}

History WaterFilledLaw::accept(const Vec2& q, const History& h, double k) const {
  const Shift water = shift(q, h, k);
  History out = law_->accept(water.of(q), h, k);
  const double opening = q.x() + water.c - law_->respond(water.of(q), h, k).traction.x() / k;
  const auto before = h.memory.as<WaterMemory>(behind_);
  const double work = before.work + 0.5 * k * (before.shift + water.c) * (opening - before.opening);
  out.memory.keep(WaterMemory{water.c, opening, work}, behind_);
  return out;
}

/// The spring holds t, not t₀.
double WaterFilledLaw::stored(const Vec2& q, const History& h, double k) const {
  const Shift water = shift(q, h, k);
  const double pressure = k * water.c, of_solid = law_->respond(water.of(q), h, k).traction.x();
  return law_->stored(water.of(q), h, k) + pressure * (0.5 * pressure - of_solid) / k;
}

unsigned WaterFilledLaw::piece(const Vec2& q, const History& h, double k) const {
  constexpr unsigned filled = 32;
  const Shift water = shift(q, h, k);
  return law_->piece(water.of(q), h, k) + (k * water.c >= full_ ? filled : 0u);
}

History WaterFilledLaw::grown(const History& h, double k, double factor) const {
  History out = law_->grown(h, k, factor);
  if (!is_crack_) return out;
  auto water = h.memory.as<WaterMemory>(behind_);
  water.shift = at(kappa(out, k), k).pressure / k;
  out.memory.keep(water, behind_);
  return out;
}

std::optional<Contact> WaterFilledLaw::contact(const History& h, double k) const {
  std::optional<Contact> out = law_->contact(h, k);
  if (!out) return out;
  out->shift = frozen(h, k).c;
  out->pressure = k * out->shift;
  return out;
}

double WaterFilledLaw::supplied(const History& h) const { return h.memory.as<WaterMemory>(behind_).work; }

double WaterFilledLaw::water_pressure(const History& h, double k) const { return k * frozen(h, k).c; }

}  // namespace dda
