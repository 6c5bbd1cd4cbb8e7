#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>

#include "continuation/state/system.hpp"

namespace dda {

/// Where a control is evaluated: at a state, or an iterate of all unknowns.
struct ControlPoint {
  std::variant<std::span<const double>, const Displacements*> d;
  double load_factor;
  const LawValues& laws;

  static ControlPoint at(const State& state, const LawValues& laws) {
    return {&state.d, state.load_factor, laws};
  }
  double value(const Functional& gauge) const {
    if (const auto* state = std::get_if<const Displacements*>(&d)) return (*state)->value(gauge, load_factor);
    return gauge.value(std::get<std::span<const double>>(d), load_factor);
  }
};

/// A control in parts, N = (g(d, λ) + Σ W (energy that accepting q spends) − target)/scale.
struct ControlSum {
  const Functional* gauge = nullptr;  ///< g, if any
  bool spends = false;                ///< whether the energy enters
  double target = 0;
  double scale = 1;
};

/// A gauge and the value that it is to have.
struct WantedGauge {
  Functional gauge;
  double value = 0;
};

/// One scalar equation that closes equilibrium, N(d, λ, s) = 0: which point of the path is wanted.
///
///     N = (value(d, λ) − target(s)) / scale,      s the abstract path parameter, 0 at the start of a step
///
/// The start is fixed by `start_at`; then N(start, 0) = 0. Residuals are dimensionless.
class ControlEquation {
 public:
  virtual ~ControlEquation() = default;
  /// Fixes the start of the step, and by `scale` what counts as one (the size of the step in units of s).
  virtual void start_at(const ControlPoint& start, double scale) = 0;
  virtual double residual(const ControlPoint& at, double s) const = 0;
  /// Adds ∂N/∂d to a zero vector of size n and returns ∂N/∂λ.
  virtual double gradient(const ControlPoint& at, std::span<double> per_d) const = 0;
  /// ∂N/∂s.
  virtual double per_path() const = 0;
  /// N(·, ·, s) in parts, of controls that consist of them.
  virtual std::optional<ControlSum> as_sum(double) const { return {}; }
  /// N(·, ·, s) = 0 made linear at a state, of controls that look at every point.
  virtual std::optional<WantedGauge> tangent_gauge(const ControlPoint&, double) const { return {}; }
  /// Whether the laws are to answer with frozen damage under this control.
  virtual bool freezes_damage() const { return false; }
  /// Whether nothing is to be met exactly: the control only decides how far the step goes.
  virtual bool only_sizes_step() const { return false; }
};

/// A gauge prescribed, g(d, λ) − g_start = s. Load, displacement and opening control; s in the gauge's unit.
std::unique_ptr<ControlEquation> make_gauge_equation(Functional gauge);

/// Dissipation prescribed: Σ W (energy that accepting q would spend) = s, s an energy. Source:
/// models/README.md.
std::unique_ptr<ControlEquation> make_dissipation_equation(const System& system);

/// Which initiations an event control looks for.
enum class Initiation {
  frozen,   ///< of any unbroken point, the damage of all being frozen meanwhile
  new_one,  ///< of a point that is not loading now, while the damage of the others follows
  awaited,  ///< likewise, of points at which a step has to end: see is_awaited
  corner    ///< not of a crack: a loading point passes a corner of its curve, as where its traction ends
};

/// Whether steps end where a point reaches its strength: it loses it at once, or a crack goes on by it.
inline bool is_awaited(const InterfacePoint& point) {
  return point.is_awaited || point.law->releases_at_once();
}

/// The next initiation: max over those points of q_eq/κ − 1 = 0 at s = 1; for corners κ is that of the
/// point's next corner, passed by 1e-9 so that nothing is left of the piece before it.
std::unique_ptr<ControlEquation> make_event_equation(const System& system,
                                                     Initiation kind = Initiation::frozen);

}  // namespace dda
