#include "continuation/equation/control_equation.hpp"

namespace dda {
namespace {

class GaugeEquation final : public ControlEquation {
 public:
  explicit GaugeEquation(Functional gauge) : gauge_(std::move(gauge)) {}

  void start_at(const ControlPoint& start, double scale) override {
    start_ = start.value(gauge_);
    scale_ = scale;
  }
  double residual(const ControlPoint& at, double s) const override {
    return (at.value(gauge_) - start_ - s) / scale_;
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

std::unique_ptr<ControlEquation> make_gauge_equation(Functional gauge) {
  return std::make_unique<GaugeEquation>(std::move(gauge));
}

}  // namespace dda
