#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <map>

#include "models/interface/softening/softening_parameters.hpp"
#include "python/core/bindings.hpp"
#include "python/core/own_classes.hpp"
#include "python/core/python_law.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;

/// What a deck gives: of a curve the keys of all softening laws, and the numbers that the class declares.
struct LawParameters : SofteningParameters {
  std::map<std::string, double> own;
};

using Memory = std::vector<std::pair<std::string, int>>;  ///< names, and powers of length

std::vector<Remembered> remembered_of(const Memory& memory) {
  std::vector<Remembered> out;
  for (const auto& [name, length] : memory) out.push_back({name, Dimension{0, length}, 1});
  return out;
}

void register_law(const std::string& name, const py::object& type) {
  const auto is_curve = type.attr("is_curve").cast<bool>();
  const auto memory = type.attr("memory").cast<Memory>();
  if (memory.size() > LawMemory::capacity) throw py::value_error("a law remembers ten numbers at most");
  const auto text = type.attr("text").cast<std::string>();
  const std::string shape =
      std::string(is_curve ? "curve " : "law ") + std::string(py::repr(py::cast(memory)));
  register_own(
      interface_laws(), name, own_class(type, shape),
      is_curve ? softening_schema<LawParameters>(text) : Schema<LawParameters>(text),
      [is_curve, memory](const OwnClass& law, const LawParameters& p) -> std::unique_ptr<InterfaceLaw> {
        const py::gil_scoped_acquire lock;
        if (is_curve) return std::make_unique<DamageLaw>(p.numbers(), python_shape(law.object(p.own)));
        return python_law(law.object(p.own), remembered_of(memory));
      });
}

void bind_history(py::module_& module) {
  const auto at = [](std::size_t i) {
    if (i >= LawMemory::capacity) throw py::index_error("a law remembers ten numbers of a point");
    return i;
  };
  py::class_<History>(module, "History", "What an interface point remembers of the last accepted step.")
      .def(py::init<>())
      .def("copy", [](const History& h) { return h; })
      .def_readwrite("loading", &History::loading)
      .def_readwrite("sliding", &History::sliding)
      .def_readwrite("share", &History::share)
      .def_readwrite("dissipated", &History::dissipated)
      .def("__getitem__", [at](const History& h, std::size_t i) { return h.memory.numbers()[at(i)]; })
      .def("__setitem__",
           [at](History& h, std::size_t i, double value) { h.memory.numbers()[at(i)] = value; });
}

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What a law of a deck, given as YAML, answers to openings one after another, each accepted: tractions, damage, and what
/// has been dissipated.
py::tuple respond_along(const std::string& yaml, const Rows& openings, double k) {
  if (openings.ndim() != 2 || openings.shape(1) != 2)
    throw py::value_error("openings are n rows of (q_n, q_s)");
  if (!(k > 0)) throw py::value_error("the trial stiffness is larger than 0");
  const auto law = interface_laws().choose(parse_yaml(yaml, "law")).make();
  const auto count = openings.shape(0);
  py::array_t<double> tractions({count, py::ssize_t(2)}), damage(count), dissipated(count);
  const auto q = openings.unchecked<2>();
  auto t = tractions.mutable_unchecked<2>();
  auto d = damage.mutable_unchecked<1>(), spent = dissipated.mutable_unchecked<1>();
  History h;
  for (py::ssize_t i = 0; i < count; ++i) {
    const Vec2 at(q(i, 0), q(i, 1));
    const Vec2 traction = law->respond(at, h, k).traction;
    h = law->accept(at, h, k);
    t(i, 0) = traction.x();
    t(i, 1) = traction.y();
    d(i) = law->damage(h, k);
    spent(i) = h.dissipated;
  }
  return py::make_tuple(tractions, damage, dissipated);
}

}  // namespace

void bind_laws(py::module_& module) {
  bind_history(module);
  module.def("respond_along", &respond_along);
  module.def("register_law", &register_law);
}

}  // namespace dda::python
