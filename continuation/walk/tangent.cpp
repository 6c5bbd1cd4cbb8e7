#include "continuation/walk/tangent.hpp"

#include <algorithm>
#include <cmath>

#include "continuation/contact/rate_walk.hpp"
#include "continuation/walk/power.hpp"
#include "continuation/walk/snap_back.hpp"

namespace dda {
namespace {

/// K⁻¹ ∂f/∂λ with the history's flags, per unit of load factor; empty when K is singular.
Tangent direction(System& system, const State& state) {
  Tangent out;
  const auto laws = system.laws_at(state);
  if (!system.use_path_tangent(*laws)) return out;
  out.d = system.load_direction(*laws);
  out.load_factor = 1;
  out.multipliers = system.multiplier_rates(out.d);
  out.opening.resize(laws->opening.size());
  for (std::size_t p = 0; p < out.opening.size(); ++p)
    out.opening[p] = system.opening_rate(p, out.d) + system.loading().reference_opening(p);
  return out;
}

void scale(double factor, std::vector<Vec2>& v) {
  for (Vec2& value : v) value *= factor;
}

void reverse(Tangent& along) {
  along.load_factor *= -1;
  along.d = along.d.scaled(-1);
  scale(-1, along.opening);
  scale(-1, along.multipliers);
}

/// Towards more energy spent; where none is by the heading, or as the forces of the live loads push.
Tangent oriented(System& system, const State& state, const std::optional<Heading>& heading) {
  const auto scope = system.timings().measure("tangents");
  Tangent out = direction(system, state);
  if (out.d.empty()) return out;
  const double rate = dissipation_rate(system, state, out);
  const LivePower power = live_power(system, state, out);
  constexpr double rounding = 1e-10;  // left of cracks that stand still while a mechanism turns
  out.dissipates = std::abs(rate) > rounding * power.size;
  if (!out.dissipates) {
    const double forward = heading ? heading->sign * out.rate(heading->gauge) : power.of_forces;
    if (forward < 0) reverse(out);
    return out;
  }
  out.d = out.d.scaled(1 / rate);
  scale(1 / rate, out.opening);
  scale(1 / rate, out.multipliers);
  out.load_factor = 1 / rate;
  return out;
}

/// Whether a direction just found leads back: energy is spent while the load falls off a structure that is
/// stable under it, which could bear more. What had slid or cracked under the load slides back without it.
/// Under a heading it is what that is to bring forward that goes back.
bool leads_back(System& system, const Tangent& along, const std::optional<Heading>& heading) {
  const double forward = heading ? heading->sign * along.rate(heading->gauge) : along.load_factor;
  return along.dissipates && forward < 0 && negative_eigenvalues(system).of_stiffness == 0;
}

/// A flag of a point that stands on its damage surface or at its limit of friction.
struct Flag {
  std::size_t point;
  bool History::*side;  ///< loading or sliding
};

/// The rate problem of an equilibrium: which of the points flagged in the history go on loading and sliding.
///
///     flagged:  κ̇ ≥ 0 (slip rate ≥ 0);      not flagged, on the surface:  κ̇ ≤ 0
class RateProblem {
 public:
  using Set = std::vector<bool>;
  enum class Sense { dissipates, loads };  ///< what orients the direction: energy spent, or the load factor
  RateProblem(System& system, const State& state, Sense sense, const std::optional<Heading>& heading = {})
      : system_(system), state_(state), sense_(sense), heading_(heading) {
    const auto laws = system.laws_at(state);
    for (std::size_t p = 0; p < system.history().size(); ++p) {
      const History& h = system.history()[p];
      const InterfacePoint& point = system.equilibrium().point(p);
      if (h.loading && !point.law->releases_at_once())
        add({p, &History::loading}, point.law->opening_gradient(laws->opening[p], h, point.stiffness));
      if (h.sliding)
        add({p, &History::sliding}, point.law->slip_gradient(laws->opening[p], h, point.stiffness));
    }
  }

  /// The direction in which the path goes on; flags as it needs them.
  Tangent solve(Tangent arriving) {
    Tangent found = kept(std::move(arriving));
    if (!found.d.empty()) let_rest(found);
    return found;
  }
  /// The direction in which a load sets out: where it asks for none of it nothing cracks or slides on, although that may be
  /// consistent, too, as where it presses on what has cracked; flags as it needs them.
  Tangent solve_from_rest() {
    const std::vector<History> flags = system_.history();
    set(Set(flags_.size(), false));
    if (Tangent still = tangent(); !still.d.empty() && is_settled(still)) return still;
    system_.set_history(flags);
    return solve(tangent());
  }
  /// A direction that goes on beyond a change of contact; flags as it needs them.
  std::optional<Tangent> solve_beyond(const BeyondChange& change) {
    const std::vector<History> flags = system_.history();
    beyond_ = change;
    if (auto found = walked(change.arriving)) return std::move(found->tangent);
    system_.set_history(flags);
    return {};
  }
  /// A direction along which joints slide on while the load falls and does negative work; flags as it needs them.
  std::optional<Tangent> solve_snapping(const Tangent& arriving) {
    const std::vector<History> flags = system_.history();
    may_snap_back_ = true;
    auto found = walked(arriving);
    if (found && found->tangent.load_factor < 0 && spends(found->tangent)) {
      let_rest(found->tangent);
      return std::move(found->tangent);
    }
    system_.set_history(flags);
    return {};
  }
  Tangent tangent() const {
    Tangent out = oriented(system_, state_, heading_);
    if (sense_ == Sense::loads && out.load_factor < 0) reverse(out);
    return out;
  }

 private:
  /// A consistent direction.
  struct Way {
    Tangent tangent;
    bool leads_back = false;
  };

  /// Takes off whatever unloads or sticks until the rest goes on; where something that was taken off would go
  /// on after all, or the path would turn back, walks from hinge to hinge (rate_walk.hpp).
  Tangent kept(Tangent arriving) {
    Tangent found = pruned(arriving);
    if (found.d.empty()) return found;
    const bool keeps = is_settled(found);
    if (keeps && !leads_back(system_, found, heading_) && !is_pushed_back(found)) return found;
    const std::vector<History> flags = system_.history();
    const auto other = walked(arriving);
    if (other && !(keeps && other->leads_back)) return other->tangent;
    system_.set_history(flags);
    found = tangent();
    found.keeps_equilibrium = keeps;
    return found;
  }

  /// What stands at its limit of friction and does not move is not said to slide.
  void let_rest(const Tangent& found) {
    constexpr double round_off = 1e-9;
    double fastest = 0;
    for (std::size_t i = 0; i < flags_.size(); ++i) fastest = std::max(fastest, std::abs(rate(i, found)));
    std::vector<History> history = system_.history();
    for (std::size_t i = 0; i < flags_.size(); ++i)
      if (flags_[i].side == &History::sliding && std::abs(rate(i, found)) <= round_off * fastest)
        history[flags_[i].point].sliding = false;
    system_.set_history(std::move(history));
  }

  Tangent pruned(Tangent found) {
    while (!found.d.empty() && unflag(found)) found = tangent();
    return found;
  }

  /// Of the directions to which walks lead one that does not lead back, cracks, and is nearer to that which
  /// led here.
  std::optional<Way> walked(const Tangent& arriving) {
    std::optional<Way> best;
    std::vector<History> flags;
    set(Set(flags_.size(), false));
    const auto rates = hinged_rates();
    if (!rates) return {};
    for (const double direction : {1.0, -1.0}) {
      const auto ray = follow_hinges(*rates, direction);
      if (!ray) continue;
      set(ray->goes_on);
      Way found{tangent()};
      if (found.tangent.d.empty()) continue;
      if ((may_snap_back_ && snaps_back(found.tangent, *ray)) || rises_backwards(found.tangent, *ray))
        reverse(found.tangent);
      if (!is_settled(found.tangent) || !goes_beyond(found.tangent)) continue;
      found.leads_back = leads_back(system_, found.tangent, heading_);
      if (best && !is_better(found, *best, arriving)) continue;
      best = std::move(found);
      flags = system_.history();
    }
    if (best) system_.set_history(std::move(flags));
    return best;
  }

  /// Whether joints slide on only the other way round; by rounding where the load does far more than on the elastic structure.
  bool snaps_back(Tangent found, const RateRay& ray) const {
    constexpr double far = 10;
    const bool none = std::ranges::count(ray.goes_on, true) == 0;
    if (found.dissipates || heading_ || none || is_settled(found)) return false;
    if (std::abs(live_power(system_, state_, found).of_forces) > far * elastic_power_) return false;
    reverse(found);
    return is_settled(found);
  }

  /// Whether friction takes of what the load gives back: else it is taken off, as from the limit of a mechanism of which rounding
  /// hides the rates.
  bool spends(const Tangent& found) const {
    constexpr double hardly = 0.01;
    const double given_back = std::abs(state_.load_factor * live_power(system_, state_, found).of_forces);
    return std::abs(dissipation_rate(system_, state_, found)) > hardly * given_back;
  }

  /// Whether joints slide on only the other way round, and the load rises there: what it works on goes back, as where friction
  /// steeper than its plane lets go.
  bool rises_backwards(Tangent found, const RateRay& ray) const {
    const bool none = std::ranges::count(ray.goes_on, true) == 0;
    if (found.dissipates || heading_ || none || found.load_factor >= 0 || is_settled(found)) return false;
    reverse(found);
    return is_settled(found);
  }

  /// True where nothing is asked for; what spends nothing may lead either way.
  bool goes_beyond(const Tangent& found) const {
    return !beyond_ || !found.dissipates || found.opening[beyond_->point].dot(beyond_->across) >= 0;
  }

  bool is_better(const Way& one, const Way& other, const Tangent& arriving) const {
    if (one.leads_back != other.leads_back) return other.leads_back;
    if (is_pushed_back(one.tangent) != is_pushed_back(other.tangent)) return is_pushed_back(other.tangent);
    if (one.tangent.dissipates != other.tangent.dissipates) return one.tangent.dissipates;
    return nearness(one.tangent, arriving) > nearness(other.tangent, arriving);
  }

  /// Whether a load that sets out moves the structure against itself, as where what has softened goes on: what unloads, or turns
  /// back, goes with it.
  bool is_pushed_back(const Tangent& found) const {
    constexpr double rounding = 1e-10;
    if (sense_ != Sense::loads) return false;
    const LivePower power = live_power(system_, state_, found);
    return power.of_forces < -rounding * power.size;
  }

  /// Cosine between two directions, in the openings of the points flagged.
  double nearness(const Tangent& one, const Tangent& other) const {
    double product = 0, square = 0, square_of_other = 0;
    for (const auto& [p, side] : flags_) {
      const Vec2 &a = one.opening[p], &b = other.opening[p];
      product += a.dot(b);
      square += a.squaredNorm();
      square_of_other += b.squaredNorm();
    }
    return product / std::sqrt(square * square_of_other);
  }

  /// The hinges of the structure in which no flag is set; nothing when that is singular.
  std::optional<HingedRates> hinged_rates() {
    const Tangent elastic = direction(system_, state_);
    if (elastic.d.empty()) return {};
    elastic_power_ = std::abs(live_power(system_, state_, elastic).of_forces);
    const auto n = static_cast<Eigen::Index>(flags_.size());
    HingedRates out{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) out.per_load[i] = rate(static_cast<std::size_t>(i), elastic);
    if (!couple_by_columns(out.couplings)) couple_by_solutions(out.couplings);
    return out;
  }

  /// M of the hinges from the couplings of their points, where these are known.
  bool couple_by_columns(Eigen::MatrixXd& m) {
    const std::vector<Vec2> tractions = traction_rates();
    std::vector<LinearSystem::Hinge> hinges;
    for (std::size_t i = 0; i < flags_.size(); ++i) {
      const std::size_t p = flags_[i].point;
      hinges.push_back({p, gradients_[i], system_.equilibrium().point(p).weight * tractions[i]});
    }
    auto flexibility = system_.flexibility(hinges);
    if (flexibility) m = *std::move(flexibility);
    return flexibility.has_value();
  }

  /// The same with a solution for each hinge.
  void couple_by_solutions(Eigen::MatrixXd& m) {
    const std::vector<Vec2> tractions = traction_rates();
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
      const auto at = static_cast<std::size_t>(j);
      const std::vector<Vec2> opening = system_.opened_by(flags_[at].point, tractions[at]);
      for (Eigen::Index i = 0; i < m.rows(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        m(i, j) = -gradients_[row].dot(opening[flags_[row].point]);
      }
    }
  }

  /// a of t = D q + a ⟨g · q⟩ for each flag, D that of no flag: ∂t/∂q of the flag beyond D is a gᵀ.
  std::vector<Vec2> traction_rates() const {
    std::vector<Vec2> out;
    const auto laws = system_.laws_at(state_);
    for (std::size_t i = 0; i < flags_.size(); ++i) {
      const std::size_t p = flags_[i].point;
      const InterfacePoint& point = system_.equilibrium().point(p);
      History flagged = system_.history()[p];
      flagged.*flags_[i].side = true;
      const Mat2 with = point.law->respond(laws->opening[p], flagged, point.stiffness).tangent;
      const Vec2& g = gradients_[i];
      out.push_back(g.isZero(0) ? Vec2(Vec2::Zero()) : Vec2((with - laws->tangent[p]) * g / g.squaredNorm()));
    }
    return out;
  }

  void add(const Flag& flag, const Vec2& gradient) {
    flags_.push_back(flag);
    gradients_.push_back(gradient);
  }
  double rate(std::size_t i, const Tangent& along) const {
    return gradients_[i].dot(along.opening[flags_[i].point]);
  }
  bool is_set(std::size_t i) const { return system_.history()[flags_[i].point].*flags_[i].side; }

  bool unflag(const Tangent& found) {
    std::vector<History> history = system_.history();
    bool changed = false;
    for (std::size_t i = 0; i < flags_.size(); ++i)
      if (is_set(i) && rate(i, found) < 0) history[flags_[i].point].*flags_[i].side = !(changed = true);
    if (changed) system_.set_history(std::move(history));
    return changed;
  }

  /// Whether all flags go on along a direction and nothing else does.
  bool is_settled(const Tangent& along) const {
    constexpr double round_off = 1e-9;
    double fastest = 0, most = 0;
    for (std::size_t i = 0; i < flags_.size(); ++i) {
      const double now = rate(i, along);
      fastest = std::max(fastest, std::abs(now));
      most = std::max(most, is_set(i) ? -now : now);
    }
    return most <= round_off * fastest;
  }

  void set(const Set& goes_on) {
    std::vector<History> history = system_.history();
    for (std::size_t i = 0; i < flags_.size(); ++i) history[flags_[i].point].*flags_[i].side = goes_on[i];
    system_.set_history(std::move(history));
  }

  System& system_;
  const State& state_;
  Sense sense_;
  std::optional<Heading> heading_;
  std::optional<BeyondChange> beyond_;
  std::vector<Flag> flags_;
  std::vector<Vec2> gradients_;
  bool may_snap_back_ = false;
  double elastic_power_ = 0;  ///< of the live load while nothing is flagged, per unit of its factor
};

}  // namespace

NegativeEigenvalues negative_eigenvalues(System& system) {
  NegativeEigenvalues out = system.path_linear().negative_eigenvalues();
  const auto multipliers = static_cast<int>(system.equilibrium().num_unknown_multipliers());
  // Each adds one that is negative, as long as K is symmetric: what slides has other rows than columns.
  if (multipliers > 0 && !out.of_stiffness) return {};
  for (auto* count : {&out.of_stiffness, &out.of_symmetric_part})
    if (*count) **count -= multipliers;
  return out;
}

Tangent arriving_tangent(System& system, const State& state, const std::optional<Heading>& heading) {
  return oriented(system, state, heading);
}

Tangent leaving_tangent(System& system, const State& state, Tangent arriving,
                        const std::optional<Heading>& heading) {
  return RateProblem(system, state, RateProblem::Sense::dissipates, heading).solve(std::move(arriving));
}

std::optional<Tangent> tangent_beyond(System& system, const State& state,
                                      const std::optional<Heading>& heading, const BeyondChange& change) {
  return RateProblem(system, state, RateProblem::Sense::dissipates, heading).solve_beyond(change);
}

std::optional<Tangent> snapping_tangent(System& system, const State& state, const Tangent& arriving) {
  return RateProblem(system, state, RateProblem::Sense::dissipates).solve_snapping(arriving);
}

Tangent starting_tangent(System& system, const State& state) {
  return RateProblem(system, state, RateProblem::Sense::loads).solve_from_rest();
}

}  // namespace dda
