#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "models/body/place.hpp"
#include "models/load/load.hpp"
#include "python/core/asked.hpp"
#include "python/core/bindings.hpp"
#include "python/core/own_classes.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;

/// The blocks as a load of Python is shown them: arrays by block.
py::object blocks_of(const Body& body) {
  const auto count = static_cast<py::ssize_t>(body.assembly.num_blocks());
  py::array_t<double> centroids({count, py::ssize_t(2)}), areas(count);
  py::list outlines, regions, materials;
  for (py::ssize_t b = 0; b < count; ++b) {
    const Block& block = body.block(BlockId(static_cast<std::size_t>(b)));
    centroids.mutable_at(b, 0) = block.moments.centroid.x();
    centroids.mutable_at(b, 1) = block.moments.centroid.y();
    areas.mutable_at(b) = block.moments.area;
    const auto corners = static_cast<py::ssize_t>(block.outline.vertices.size());
    py::array_t<double> outline({corners, py::ssize_t(2)});
    for (py::ssize_t i = 0; i < corners; ++i)
      for (const int axis : {0, 1})
        outline.mutable_at(i, axis) = block.outline.vertices[static_cast<std::size_t>(i)][axis];
    outlines.append(std::move(outline));
    const Region& region = body.assembly.regions[block.region];
    regions.append(region.name);
    materials.append(region.material);
  }
  return py::module_::import("types").attr("SimpleNamespace")(
      py::arg("centroids") = centroids, py::arg("areas") = areas, py::arg("outlines") = outlines,
      py::arg("regions") = regions, py::arg("materials") = materials, py::arg("thickness") = body.thickness);
}

/// Forces at points, as a class of Python gives them: ddapath.Load.
class PythonLoad final : public Load {
 public:
  PythonLoad(py::object load, Position where) : load_(std::move(load)), where_(std::move(where)) {}

  void add_to(StageLoads& stage, const Body& body) const override {
    using Forces = std::vector<std::pair<Vec2, Vec2>>;
    const auto forces = [&] {
      const py::gil_scoped_acquire lock;
      const py::list given(load_.object().attr("point_forces")(blocks_of(body)));
      return load_.value<Forces>(given, "point_forces");
    }();
    for (const auto& [place, force] : forces) {
      const Place at{.at = Spot(place), .inside = {}, .over = {}};
      displacement_at(body, at, Vec2::UnitX(), where_).add_gradient(force.x(), stage.force);
      displacement_at(body, at, Vec2::UnitY(), where_).add_gradient(force.y(), stage.force);
      stage.resultant += force.norm();
    }
  }

 private:
  Asked load_;
  Position where_;
};

void register_load(const std::string& name, const py::object& type) {
  register_own(loads(), name, own_class(type), Schema<OwnParameters>(type.attr("text").cast<std::string>()),
               [](const OwnClass& load, const OwnParameters& p) -> std::unique_ptr<Load> {
                 const py::gil_scoped_acquire lock;
                 return std::make_unique<PythonLoad>(load.object(p.own), p.where);
               });
}

}  // namespace

void bind_loads(py::module_& module) { module.def("register_load", &register_load); }

}  // namespace dda::python
