#include "models/interface/softening/softening_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda {
namespace {

class PiecewiseLinear final : public SofteningShape {
 public:
  explicit PiecewiseLinear(std::vector<Vec2> vertices) : v_(std::move(vertices)) {
    for (std::size_t i = 0; i + 1 < v_.size(); ++i)
      areas_.push_back((i ? areas_.back() : 0) +
                       0.5 * (v_[i].y() + v_[i + 1].y()) * (v_[i + 1].x() - v_[i].x()));
  }

  double value(double omega) const override {
    const std::size_t i = piece(omega);
    return i == pieces() ? 0 : v_[i].y() + slope_of(i) * (omega - v_[i].x());
  }
  double slope(double omega) const override {
    const std::size_t i = piece(omega);
    return i == pieces() ? 0 : slope_of(i);
  }
  double steepest() const override {
    double out = 0;
    for (std::size_t i = 0; i < pieces(); ++i) out = std::max(out, -slope_of(i));
    return out;
  }
  double end() const override { return v_.back().x(); }
  double next_corner(double omega) const override {
    const std::size_t i = piece(omega);
    return i == pieces() ? std::numeric_limits<double>::infinity() : v_[i + 1].x();
  }
  double spent(double omega) const override {
    const std::size_t i = piece(omega);
    if (i == pieces()) return areas_.back();
    const double g = value(omega);
    const double area = (i ? areas_[i - 1] : 0) + 0.5 * (v_[i].y() + g) * (omega - v_[i].x());
    return area - 0.5 * omega * g;
  }
  double at_trial_opening(double opening, double scale, double kappa0) const override {
    for (std::size_t i = 0; i < pieces(); ++i)
      if (opening < scale * v_[i + 1].x() + kappa0 * v_[i + 1].y())
        return std::max(v_[i].x(), (opening - kappa0 * (v_[i].y() - slope_of(i) * v_[i].x())) /
                                       (scale + kappa0 * slope_of(i)));
    return opening / scale;
  }
  double at_same_compliance(double omega, double ratio) const override {
    const double g = value(omega);
    if (g <= 0) return omega;
    const double compliance = ratio * omega / g;
    for (std::size_t i = 0; i < pieces(); ++i) {
      const Vec2& to = v_[i + 1];
      if (to.y() > 0 && compliance >= to.x() / to.y()) continue;
      return compliance * (v_[i].y() - slope_of(i) * v_[i].x()) / (1 - compliance * slope_of(i));
    }
    return end();
  }

 private:
  std::size_t pieces() const { return v_.size() - 1; }
  double slope_of(std::size_t i) const { return (v_[i + 1].y() - v_[i].y()) / (v_[i + 1].x() - v_[i].x()); }
  std::size_t piece(double omega) const {
    std::size_t i = 0;
    while (i < pieces() && omega >= v_[i + 1].x()) ++i;
    return i;
  }

  std::vector<Vec2> v_;
  std::vector<double> areas_;  ///< ∫ g up to the end of each piece
};

class Exponential final : public SofteningShape {
 public:
  double value(double omega) const override { return std::exp(-omega); }
  double slope(double omega) const override { return -std::exp(-omega); }
  double steepest() const override { return 1; }
  double end() const override { return std::numeric_limits<double>::infinity(); }
  double next_corner(double) const override { return std::numeric_limits<double>::infinity(); }
  double spent(double omega) const override { return -std::expm1(-omega) - 0.5 * omega * std::exp(-omega); }
  /// Convex and rising for scale > kappa0: Newton from the right never overshoots.
  double at_trial_opening(double opening, double scale, double kappa0) const override {
    double omega = opening / scale;
    for (int i = 0; i < 60; ++i) {
      const double g = std::exp(-omega);
      const double next =
          std::max(0.0, omega - (scale * omega + kappa0 * g - opening) / (scale - kappa0 * g));
      if (std::abs(next - omega) <= 1e-15 * omega) return next;
      omega = next;
    }
    return omega;
  }
  /// ω' + ln ω' = ω + ln(ratio ω), concave and rising: Newton from the left.
  double at_same_compliance(double omega, double ratio) const override {
    if (omega <= 0) return omega;
    const double goal = omega + std::log(ratio * omega);
    double x = std::min(1.0, ratio) * omega;
    for (int i = 0; i < 60; ++i) {
      const double next = x - (x + std::log(x) - goal) * x / (1 + x);
      if (std::abs(next - x) <= 1e-15 * x) return next;
      x = next;
    }
    return x;
  }
};

}  // namespace

std::unique_ptr<SofteningShape> piecewise_linear_shape(std::vector<Vec2> vertices) {
  return std::make_unique<PiecewiseLinear>(std::move(vertices));
}

std::unique_ptr<SofteningShape> exponential_shape() { return std::make_unique<Exponential>(); }

}  // namespace dda
