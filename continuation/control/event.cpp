#include <limits>

#include "continuation/control/control.hpp"

namespace dda {
namespace {

class EventControl final : public Control {
 public:
  EventControl(const System& system, bool only_at_once) : system_(system), only_at_once_(only_at_once) {}

  void start_at(const ControlPoint& start, double) override { start_ = nearest(start).distance; }
  double residual(const ControlPoint& at, double s) const override {
    return nearest(at).distance - (1 - s) * start_;
  }

  double gradient(const ControlPoint& at, std::span<double> per_d) const override {
    const Nearest found = nearest(at);
    if (found.point < 0) return 0;
    const auto p = static_cast<std::size_t>(found.point);
    const InterfacePoint& point = system_.equilibrium().point(p);
    const Vec2 e = point.law->opening_gradient(at.laws.opening[p], system_.history()[p], point.stiffness) /
                   system_.kappa(p);
    Functional row;
    point.for_each_part(
        [&](BlockId part, const Mat26& rows) { row.rows.emplace_back(part, rows.transpose() * e); });
    row.add_gradient(1, per_d);
    const auto& offset = system_.loading().reference_offset;
    return offset.empty() ? 0 : e.dot(Eigen::Map<const Vec2>(offset.data() + 2 * p));
  }

  double per_path() const override { return start_; }
  bool freezes_damage() const override { return !only_at_once_; }

 private:
  struct Nearest {
    int point = -1;
    double distance = -1;  ///< q_eq/κ − 1
  };
  Nearest nearest(const ControlPoint& at) const {
    Nearest best{-1, -std::numeric_limits<double>::infinity()};
    for (std::size_t p = 0; p < at.laws.opening.size(); ++p) {
      const InterfacePoint& point = system_.equilibrium().point(p);
      if (system_.is_broken(p) || (only_at_once_ && !point.law->releases_at_once())) continue;
      const double opening =
          point.law->equivalent_opening(at.laws.opening[p], system_.history()[p], point.stiffness);
      const double distance = opening / system_.kappa(p) - 1;
      if (distance > best.distance) best = {static_cast<int>(p), distance};
    }
    return best.point < 0 ? Nearest{} : best;
  }

  const System& system_;
  bool only_at_once_;
  double start_ = -1;
};

}  // namespace

std::unique_ptr<Control> make_event_control(const System& system) {
  return std::make_unique<EventControl>(system, false);
}

std::unique_ptr<Control> make_strength_control(const System& system) {
  return std::make_unique<EventControl>(system, true);
}

}  // namespace dda
