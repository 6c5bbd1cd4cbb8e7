#include "continuation/control/control.hpp"

namespace dda {
namespace {

class GaugeControl final : public Control {
 public:
  explicit GaugeControl(Functional gauge) : gauge_(std::move(gauge)) {}

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

std::unique_ptr<Control> make_gauge_control(Functional gauge) {
  return std::make_unique<GaugeControl>(std::move(gauge));
}

}  // namespace dda
