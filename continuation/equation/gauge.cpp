#include "continuation/equation/control_equation.hpp"

namespace dda {
namespace {

class GaugeEquation final : public ControlEquation {
 public:
  explicit GaugeEquation(Functional gauge) : gauge_(std::move(gauge)) {}

  void start_at(const ControlPoint& start, double scale) override {
    start_ = gauge_.value(start.d, start.load_factor);
    scale_ = scale;
  }
  double residual(const ControlPoint& at, double s) const override {
    return (gauge_.value(at.d, at.load_factor) - start_ - s) / scale_;
  }
  double gradient(const ControlPoint&, std::span<double> per_d) const override {
    gauge_.add_gradient(1 / scale_, per_d);
    return gauge_.per_load_factor / scale_;
  }
  std::optional<ControlSum> as_sum(double s) const override {
    return ControlSum{.gauge = &gauge_, .spends = false, .target = start_ + s, .scale = scale_};
  }
  double per_path() const override { return -1 / scale_; }

 private:
  Functional gauge_;
  double start_ = 0, scale_ = 1;
};

}  // namespace

ControlPoint seen_by(const ControlEquation& control, const State& at, const LawValues& laws) {
  const auto sum = control.as_sum(0);
  return {sum && sum->gauge ? at.d.asked_by(*sum->gauge) : at.d.watched(), at.load_factor, laws};
}

std::unique_ptr<ControlEquation> make_gauge_equation(Functional gauge) {
  return std::make_unique<GaugeEquation>(std::move(gauge));
}

}  // namespace dda
