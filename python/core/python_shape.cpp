#include "python/core/python_law.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;

class PythonShape final : public SofteningShape {
 public:
  explicit PythonShape(py::object curve) : curve_(std::move(curve)) {}

  double value(double omega) const override { return curve_.ask<double>("value", omega); }
  double slope(double omega) const override { return curve_.ask<double>("slope", omega); }
  double steepest() const override { return curve_.ask<double>("steepest"); }
  double end() const override { return curve_.ask<double>("end"); }
  double next_corner(double omega) const override { return curve_.ask<double>("next_corner", omega); }
  double spent(double omega) const override { return curve_.ask<double>("spent", omega); }
  double at_trial_opening(double opening, double scale, double kappa0) const override {
    return curve_.ask<double>("at_trial_opening", opening, scale, kappa0);
  }
  double at_same_compliance(double omega, double ratio) const override {
    return curve_.ask<double>("at_same_compliance", omega, ratio);
  }

 private:
  Asked curve_;
};

}  // namespace

std::unique_ptr<SofteningShape> python_shape(py::object curve) {
  return std::make_unique<PythonShape>(std::move(curve));
}

}  // namespace dda::python
