#include <pybind11/stl.h>

#include "continuation/control/control.hpp"
#include "framework/base/suggestion.hpp"
#include "python/core/asked.hpp"
#include "python/core/bindings.hpp"
#include "python/core/own_classes.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;

/// A combination of gauges that a class of Python names before each step: ddapath.Control.
class PythonControl final : public Control {
 public:
  PythonControl(py::object control, const GaugeBook& book)
      : control_(std::move(control)), gauges_(book.gauges) {
    gauges_.push_back({"load_factor", {.rows = {}, .per_load_factor = 1}, dimension::none});
  }

  Move next(Walker& walker) override {
    Functional prescribed = combination(walker);
    const double rate = walker.leaving().rate(prescribed);
    if (rate == 0) fail("gives what does not move along the path");
    return {
        .kind = StepKind::displacement, .equation = make_gauge_equation(std::move(prescribed)), .rate = rate};
  }

 private:
  Functional combination(const Walker& walker) const {
    const py::gil_scoped_acquire lock;
    py::dict values, rates;
    for (const NamedGauge& gauge : gauges_) {
      values[py::str(gauge.name)] = walker.value(gauge.functional);
      rates[py::str(gauge.name)] = walker.leaving().rate(gauge.functional);
    }
    const auto at = py::module_::import("types").attr("SimpleNamespace")(py::arg("values") = values,
                                                                         py::arg("rates") = rates);
    Functional out;
    for (const auto& [name, weight] : control_.value<std::map<std::string, double>>(
             control_.object().attr("prescribed")(at), "prescribed"))
      out.add(weight, gauge(name));
    return out;
  }

  const Functional& gauge(const std::string& name) const {
    std::vector<std::string> names;
    for (const NamedGauge& known : gauges_) {
      if (known.name == name) return known.functional;
      names.push_back(known.name);
    }
    fail("names '" + name + "', which is not among the gauges" + suggest(name, names));
  }

  [[noreturn]] void fail(const std::string& why) const {
    const py::gil_scoped_acquire lock;
    throw py::value_error(std::string(py::str(py::type::of(control_.object()).attr("__qualname__"))) +
                          ".prescribed " + why);
  }

  Asked control_;
  std::vector<NamedGauge> gauges_;
};

void register_control(const std::string& name, const py::object& type) {
  register_own(
      controls(), name, own_class(type), Schema<OwnParameters>(type.attr("text").cast<std::string>()),
      [](const OwnClass& control, const OwnParameters& p, const GaugeBook& book) -> std::unique_ptr<Control> {
        const py::gil_scoped_acquire lock;
        return std::make_unique<PythonControl>(control.object(p.own), book);
      });
}

}  // namespace

void bind_controls(py::module_& module) { module.def("register_control", &register_control); }

}  // namespace dda::python
