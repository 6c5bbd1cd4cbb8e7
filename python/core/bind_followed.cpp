#include <pybind11/stl.h>

#include "python/core/bindings.hpp"
#include "python/core/follower.hpp"
#include "studies/dda/run/recording/summary.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;
using PointPointer = std::shared_ptr<AcceptedPoint>;

/// An array that looks at numbers which `owner` keeps: nothing is copied, nothing may be written.
template <class T>
py::array looking_at(const T* numbers, std::vector<py::ssize_t> shape, const py::handle& owner) {
  py::array out = py::array_t<T>(std::move(shape), numbers, owner);
  out.attr("setflags")(py::arg("write") = false);
  return out;
}

py::array of_vectors(const std::vector<Vec2>& values, const py::handle& owner) {
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  return looking_at(reinterpret_cast<const double*>(values.data()), {py::ssize_t(values.size()), 2}, owner);
}

/// An array that keeps a vector.
template <class T>
py::array kept(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto* keeper = new std::vector<T>(std::move(values));
  const py::capsule owner(keeper, [](void* kept) { delete static_cast<std::vector<T>*>(kept); });
  return py::array_t<T>(std::move(shape), keeper->data(), owner);
}

template <class T>
py::array kept(std::vector<T> values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return kept(std::move(values), {size});
}

const AcceptedPoint& point_of(const py::object& self) { return self.cast<const AcceptedPoint&>(); }

py::dict dictionary(const std::vector<std::pair<std::string, double>>& values) {
  py::dict out;
  for (const auto& [name, value] : values) out[py::str(name)] = value;
  return out;
}

py::dict dictionary(const Outlines& outlines, const py::handle& owner) {
  const auto rows = [&](const std::vector<double>& values) {
    return looking_at(values.data(), {py::ssize_t(values.size() / 2), 2}, owner);
  };
  const auto numbers = [&](const std::vector<std::int64_t>& values) {
    return looking_at(values.data(), {py::ssize_t(values.size())}, owner);
  };
  py::dict out;
  out["vertices"] = rows(outlines.vertices);
  out["displacements"] = rows(outlines.displacements);
  out["offsets"] = numbers(outlines.offsets);
  out["region"] = numbers(outlines.region);
  return out;
}

void add_numbers(py::class_<AcceptedPoint, PointPointer>& type) {
  using P = AcceptedPoint;
  type.def_property_readonly("step", [](const P& p) { return p.point().step; })
      .def_property_readonly(
          "control", [](const P& p) { return p.point().step == 0 ? "start" : to_string(p.point().kind); })
      .def_property_readonly("landed", [](const P& p) { return p.point().landed; })
      .def_property_readonly("stage", &P::stage)
      .def_property_readonly("load_factor", [](const P& p) { return p.state().state.load_factor; })
      .def_property_readonly("load", &P::load)
      .def_property_readonly("gauges", [](const P& p) { return dictionary(p.gauges()); })
      .def_property_readonly("reactions", [](const P& p) { return dictionary(p.reactions()); })
      .def_property_readonly("dissipated_energy", [](const P& p) { return p.state().dissipated; })
      .def_property_readonly("stored_energy", [](const P& p) { return p.state().stored; })
      .def_property_readonly("external_work", [](const P& p) { return p.state().work; })
      .def_property_readonly("iterations", [](const P& p) { return p.point().newton_iterations; })
      .def_property_readonly("relative_residual", [](const P& p) { return p.point().residual; })
      .def_property_readonly("negative_eigenvalues", [](const P& p) { return p.point().num_negative; })
      .def_property_readonly("negative_under_control",
                             [](const P& p) { return p.point().num_negative_under_control; });
}

void add_arrays(py::class_<AcceptedPoint, PointPointer>& type) {
  type.def_property_readonly(
          "displacements",
          [](const py::object& self) {
            const auto& p = point_of(self);
            return looking_at(p.displacements().data(), {py::ssize_t(p.num_blocks()), 6}, self);
          })
      .def_property_readonly("unknowns",
                             [](const py::object& self) {
                               const auto& d = point_of(self).displacements();
                               return looking_at(d.data(), {py::ssize_t(d.size())}, self);
                             })
      .def_property_readonly(
          "openings",
          [](const py::object& self) { return of_vectors(point_of(self).interface().opening, self); })
      .def_property_readonly(
          "jumps", [](const py::object& self) { return of_vectors(point_of(self).interface().jump, self); })
      .def_property_readonly(
          "tractions",
          [](const py::object& self) { return of_vectors(point_of(self).interface().traction, self); })
      .def_property_readonly(
          "outlines", [](const py::object& self) { return dictionary(point_of(self).outlines(), self); })
      .def_property_readonly("damage", [](const py::object& self) {
        const auto& damage = point_of(self).interface().damage;
        return looking_at(damage.data(), {py::ssize_t(damage.size())}, self);
      });
}

py::tuple arrays_of(BlockRows rows) {
  const auto count = static_cast<py::ssize_t>(rows.columns.size());
  return py::make_tuple(kept(std::move(rows.data), {count, 6, 6}), kept(std::move(rows.columns)),
                        kept(std::move(rows.starts)));
}

py::tuple arrays_of(const StiffnessModes& found) {
  const auto& [values, shapes] = found.modes;
  const std::size_t n = shapes.empty() ? 0 : shapes.front().size();
  std::vector<double> flat;
  for (const auto& shape : shapes) flat.insert(flat.end(), shape.begin(), shape.end());
  return py::make_tuple(kept(values), kept(std::move(flat), {py::ssize_t(shapes.size()), py::ssize_t(n)}),
                        found.num_negative);
}

/// Where the points that can crack stand, m × 2, their normals and weights, and which interface each belongs to.
py::dict points_of(const Follower& follower) {
  const Equilibrium& equilibrium = follower.followed().equilibrium();
  std::vector<double> at, normal, weight;
  std::vector<std::string> interface;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    at.insert(at.end(), {point.x.x(), point.x.y()});
    normal.insert(normal.end(), {point.normal.x(), point.normal.y()});
    weight.push_back(point.weight);
    interface.push_back(point.interface < 0 ? ""
                                            : equilibrium.interfaces().names[std::size_t(point.interface)]);
  }
  const auto count = static_cast<py::ssize_t>(weight.size());
  py::dict out;
  out["x"] = kept(std::move(at), {count, 2});
  out["normal"] = kept(std::move(normal), {count, 2});
  out["weight"] = kept(std::move(weight));
  out["interface"] = interface;
  return out;
}

EigenvalueMass mass_named(const std::string& name) {
  if (name == "none") return EigenvalueMass::none;
  if (name == "unit") return EigenvalueMass::unit;
  if (name == "density") return EigenvalueMass::density;
  throw py::value_error("modes: mass is 'none', 'unit' or 'density', not '" + name + "'");
}

std::optional<RunOptions> options_of(const std::optional<std::string>& folder, bool overwrite) {
  if (!folder) return {};
  return RunOptions{.folder = *folder, .overwrite = overwrite, .quiet = true, .profile = false};
}

void add_steering(py::class_<Follower>& type) {
  type.def_property("control", &Follower::control, &Follower::switch_control)
      .def_property("next_step", &Follower::next_step, &Follower::set_next_step)
      .def("next", &Follower::next)
      .def("go_on_with", &Follower::go_on_with)
      .def("conclude", &Follower::conclude)
      .def("stop",
           [](Follower& f, const std::string& reason) {
             f.end({Ending::Kind::goal_reached, reason});
           })
      .def("leave",
           [](Follower& f) {
             f.end({Ending::Kind::interrupted, "interrupted"});
           })
      .def_property_readonly("here", &Follower::here)
      .def_property_readonly("has_ended", [](const Follower& f) { return f.run().has_ended(); })
      .def_property_readonly("status", [](const Follower& f) { return status_of(f.ending()); })
      .def_property_readonly("reason", [](const Follower& f) { return f.ending().reason; });
}

}  // namespace

void bind_followed(py::module_& module) {
  py::class_<AcceptedPoint, PointPointer> point(module, "Point");
  add_numbers(point);
  add_arrays(point);
  py::class_<Follower> follower(module, "Follower");
  follower
      .def(py::init(
          [](std::string text, std::string name, std::vector<std::string> settings, bool is_dictionary) {
            return std::make_unique<Follower>(
                GivenDeck{std::move(text), std::move(name), std::move(settings), is_dictionary});
          }))
      .def("begin", [](Follower& f, const std::optional<std::string>& folder,
                       bool overwrite) { f.begin(options_of(folder, overwrite)); })
      .def("stiffness", [](const Follower& f) { return arrays_of(f.stiffness()); })
      .def("modes", [](Follower& f, int count,
                       const std::string& mass) { return arrays_of(f.modes(count, mass_named(mass))); })
      .def("residual", [](const Follower& f) { return kept(f.residual()); })
      .def("load_vector", [](const Follower& f) { return kept(f.load_vector()); })
      .def("reference_load", [](const Follower& f) { return kept(f.reference_load()); })
      .def("points", &points_of)
      .def_property_readonly("notices", [](const Follower& f) { return f.run().simulation().notices(); })
      .def_property_readonly("units", [](const Follower& f) {
        const Units& units = f.run().deck().deck.units;
        return py::make_tuple(units.length, units.force);
      });
  add_steering(follower);
}

}  // namespace dda::python
