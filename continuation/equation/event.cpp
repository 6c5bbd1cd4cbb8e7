#include <limits>

#include "continuation/equation/control_equation.hpp"

namespace dda {
namespace {

class EventEquation final : public ControlEquation {
 public:
  EventEquation(const System& system, Initiation kind) : system_(system), kind_(kind) {}

  void start_at(const ControlPoint& start, double) override { start_ = nearest(start).distance; }
  double residual(const ControlPoint& at, double s) const override {
    return nearest(at).distance - (1 - s) * start_;
  }

  double gradient(const ControlPoint& at, std::span<double> per_d) const override {
    const Nearest found = nearest(at);
    if (found.point < 0) return 0;
    const Functional row = gauge_of(static_cast<std::size_t>(found.point), at);
    row.add_gradient(1, per_d);
    return row.per_load_factor;
  }
  std::optional<WantedGauge> tangent_gauge(const ControlPoint& at, double s) const override {
    const Nearest found = nearest(at);
    if (found.point < 0) return {};
    Functional row = gauge_of(static_cast<std::size_t>(found.point), at);
    const double here = at.value(row);
    return WantedGauge{std::move(row), here - residual(at, s)};
  }

  double per_path() const override { return start_; }
  bool freezes_damage() const override { return kind_ == Initiation::frozen; }

 private:
  struct Nearest {
    int point = -1;
    double distance = -1;  ///< q_eq/κ − 1
  };
  Nearest nearest(const ControlPoint& at) const {
    Nearest best{-1, -std::numeric_limits<double>::infinity()};
    for (std::size_t p = 0; p < at.laws.opening.size(); ++p) {
      const InterfacePoint& point = system_.equilibrium().point(p);
      if (system_.is_broken(p) || !is_meant(p)) continue;
      const double opening =
          point.law->equivalent_opening(at.laws.opening[p], system_.history()[p], point.stiffness);
      const double distance = opening / goal(p) - 1;
      if (distance > best.distance) best = {static_cast<int>(p), distance};
    }
    return best.point < 0 ? Nearest{} : best;
  }

  /// q_eq/κ of a point, made linear.
  Functional gauge_of(std::size_t p, const ControlPoint& at) const {
    const InterfacePoint& point = system_.equilibrium().point(p);
    const Vec2 e =
        point.law->opening_gradient(at.laws.opening[p], system_.history()[p], point.stiffness) / goal(p);
    return system_.equilibrium().opening_gauge(system_.loading(), p, e);
  }

  bool is_meant(std::size_t p) const {
    if (kind_ == Initiation::awaited) return is_awaited(system_.equilibrium().point(p));
    if (kind_ == Initiation::frozen) return true;
    return system_.history()[p].loading == (kind_ == Initiation::corner);
  }
  double goal(std::size_t p) const {
    if (kind_ != Initiation::corner) return system_.kappa(p);
    constexpr double beyond = 1 + 1e-9;
    const InterfacePoint& point = system_.equilibrium().point(p);
    return beyond * point.law->next_corner(system_.history()[p], point.stiffness);
  }

  const System& system_;
  Initiation kind_;
  double start_ = -1;
};

}  // namespace

std::unique_ptr<ControlEquation> make_event_equation(const System& system, Initiation kind) {
  return std::make_unique<EventEquation>(system, kind);
}

}  // namespace dda
