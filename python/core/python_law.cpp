#include "python/core/python_law.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

namespace dda::python {
namespace {

namespace py = pybind11;

/// Numbers of the class are asked once, what hangs on the opening at every evaluation.
class PythonLaw final : public InterfaceLaw {
 public:
  PythonLaw(py::object law, std::vector<Remembered> memory)
      : law_(std::move(law)),
        memory_(std::move(memory)),
        shear_weight_(law_.ask<double>("shear_weight")),
        steepest_slope_(law_.ask<double>("steepest_slope")) {}

  std::vector<Remembered> memory() const override { return memory_; }
  double shear_weight() const override { return shear_weight_; }
  double steepest_slope() const override { return steepest_slope_; }
  bool can_crack() const override { return true; }
  double initial_kappa(double k) const override { return law_.ask<double>("initial_kappa", k); }
  double intact_bound(const History& h, double k) const override {
    return law_.ask<double>("intact_bound", h, k);
  }
  double rupture_kappa(double k) const override { return law_.ask<double>("rupture_kappa", k); }
  double next_corner(const History& h, double k) const override {
    return law_.ask<double>("next_corner", h, k);
  }
  double kappa(const History& h, double k) const override { return law_.ask<double>("kappa", h, k); }
  double equivalent_opening(const Vec2& q, const History& h, double k) const override {
    return law_.ask<double>("equivalent_opening", q.x(), q.y(), h, k);
  }
  Vec2 opening_gradient(const Vec2& q, const History& h, double k) const override {
    return law_.ask<Vec2>("opening_gradient", q.x(), q.y(), h, k);
  }
  Response respond(const Vec2& q, const History& h, double k) const override {
    return response("respond", q, h, k);
  }
  Response respond_frozen(const Vec2& q, const History& h, double k) const override {
    return response("respond_frozen", q, h, k);
  }
  Spending spending(const Vec2& q, const History& h, double k) const override {
    const auto [value, gradient] = law_.ask<std::pair<double, Vec2>>("spending", q.x(), q.y(), h, k);
    return {value, gradient};
  }
  History accept(const Vec2& q, const History& h, double k) const override {
    return law_.ask<History>("accept", q.x(), q.y(), h, k);
  }
  double stored(const Vec2& q, const History& h, double k) const override {
    return law_.ask<double>("stored", q.x(), q.y(), h, k);
  }
  double damage(const History& h, double k) const override { return law_.ask<double>("damage", h, k); }
  History grown(const History& h, double k, double factor) const override {
    return law_.ask<History>("grown", h, k, factor);
  }
  unsigned piece(const Vec2& q, const History& h, double k) const override {
    return law_.ask<unsigned>("piece", q.x(), q.y(), h, k);
  }

 private:
  Response response(const char* method, const Vec2& q, const History& h, double k) const {
    const auto [traction, tangent] = law_.ask<std::pair<Vec2, Mat2>>(method, q.x(), q.y(), h, k);
    return {traction, tangent};
  }

  Asked law_;
  std::vector<Remembered> memory_;
  double shear_weight_, steepest_slope_;
};

}  // namespace

std::unique_ptr<InterfaceLaw> python_law(py::object law, std::vector<Remembered> memory) {
  return std::make_unique<PythonLaw>(std::move(law), std::move(memory));
}

}  // namespace dda::python
