#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <map>
#include <set>

#include "models/interface/softening_parameters.hpp"
#include "python/core/bindings.hpp"
#include "python/core/python_law.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;

/// A parameter as a class of Python declares it: ddapath.Number.
struct OwnNumber {
  std::string name, text;
  Dimension dimension;
  std::optional<double> fallback, above, at_least, below, at_most;

  friend bool operator==(const OwnNumber&, const OwnNumber&) = default;
};

/// A law as it is registered. Its parameters stay, its class may be replaced by another one.
struct Registered {
  bool is_curve = false;
  std::vector<OwnNumber> numbers;
  std::vector<std::pair<std::string, int>> memory;
  py::object type;

  bool has_same_parameters(const Registered& other) const {
    return is_curve == other.is_curve && numbers == other.numbers && memory == other.memory;
  }
};

/// By name; it lives as long as the process, since classes must not be let go when Python has ended.
std::map<std::string, std::shared_ptr<Registered>>& registered() {
  static auto* all = new std::map<std::string, std::shared_ptr<Registered>>;
  return *all;
}

/// What a deck gives: of a curve the keys of all softening laws, and the numbers that the class declares.
struct LawParameters : SofteningParameters {
  std::map<std::string, double> own;
};

Bounds bounds_of(const OwnNumber& number) {
  Bounds out;
  if (number.above) out = out & above(*number.above);
  if (number.at_least) out = out & at_least(*number.at_least);
  if (number.below) out = out & below(*number.below);
  if (number.at_most) out = out & at_most(*number.at_most);
  return out;
}

/// A schema to which numbers are added by name, their values kept in a map.
class LawSchema final : public Schema<LawParameters> {
 public:
  explicit LawSchema(Schema<LawParameters> others) : Schema(std::move(others)) {}

  void add(const OwnNumber& number) {
    const Kind<double> kind = number_kind(number.dimension, bounds_of(number));
    std::optional<Node> fallback;
    if (number.fallback) fallback = Node::number(*number.fallback);
    const auto read = [kind, name = number.name](void* object, const Node& node, const Reading& reading) {
      const std::optional<double> value = kind.read(node, reading);
      if (value) static_cast<LawParameters*>(object)->own[name] = *value;
      return value.has_value();
    };
    const auto echo = [name = number.name](const void* object) -> std::optional<Node> {
      return Node::number(static_cast<const LawParameters*>(object)->own.at(name));
    };
    declare({Parameter{number.name, number.text, kind.info, std::move(fallback), false}, read, echo});
  }
};

LawSchema schema_of(const Registered& law, const std::string& text) {
  LawSchema out(law.is_curve ? softening_schema<LawParameters>(text) : Schema<LawParameters>(text));
  for (const OwnNumber& number : law.numbers) out.add(number);
  return out;
}

std::vector<Remembered> remembered_of(const Registered& law) {
  std::vector<Remembered> out;
  for (const auto& [name, length] : law.memory) out.push_back({name, Dimension{0, length}, 1});
  return out;
}

/// An object of the class with the numbers of the deck, as the law that the program asks.
std::unique_ptr<InterfaceLaw> make(const Registered& law, const LawParameters& parameters) {
  const py::gil_scoped_acquire lock;
  py::dict numbers;
  for (const auto& [name, value] : parameters.own) numbers[py::str(name)] = value;
  py::object object = law.type(**numbers);
  if (law.is_curve) return std::make_unique<DamageLaw>(parameters.numbers(), python_shape(std::move(object)));
  return python_law(std::move(object), remembered_of(law));
}

void register_law(const std::string& name, const std::string& text, Registered law) {
  auto& known = registered();
  if (const auto found = known.find(name); found != known.end()) {
    if (!found->second->has_same_parameters(law))
      throw py::value_error(
          "law '" + name +
          "' is registered with other parameters, which stay as long as this process: choose "
          "another name, or start Python again");
    found->second->type = law.type;
    return;
  }
  if (interface_laws().find(name))
    throw py::value_error("law '" + name + "' is one of the program's or of a plugin: choose another name");
  auto shared = std::make_shared<Registered>(std::move(law));
  interface_laws().add(name, static_cast<const Schema<LawParameters>&>(schema_of(*shared, text)),
                       [shared](const LawParameters& parameters) { return make(*shared, parameters); });
  known.emplace(name, std::move(shared));
}

OwnNumber number_of(const py::handle& declared) {
  OwnNumber out;
  out.name = declared.attr("name").cast<std::string>();
  out.text = declared.attr("text").cast<std::string>();
  out.dimension = {declared.attr("force").cast<int>(), declared.attr("length").cast<int>()};
  out.fallback = declared.attr("fallback").cast<std::optional<double>>();
  out.above = declared.attr("above").cast<std::optional<double>>();
  out.at_least = declared.attr("at_least").cast<std::optional<double>>();
  out.below = declared.attr("below").cast<std::optional<double>>();
  out.at_most = declared.attr("at_most").cast<std::optional<double>>();
  return out;
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
  module.def("register_law", [](const std::string& name, const py::object& type) {
    Registered law{.is_curve = type.attr("is_curve").cast<bool>(), .numbers = {}, .memory = {}, .type = type};
    for (const py::handle number : type.attr("declared_numbers")()) law.numbers.push_back(number_of(number));
    law.memory = type.attr("memory").cast<decltype(law.memory)>();
    if (law.memory.size() > LawMemory::capacity) throw py::value_error("a law remembers ten numbers at most");
    register_law(name, type.attr("text").cast<std::string>(), std::move(law));
  });
}

}  // namespace dda::python
