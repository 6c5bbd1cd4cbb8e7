#include "python/core/asked.hpp"

#include <string>

namespace dda::python {

namespace py = pybind11;

void Asked::wrong_type(const py::handle& given, const char* method) const {
  const std::string name = py::str(py::type::of(object_).attr("__qualname__"));
  throw py::type_error(name + "." + method + " gave " + std::string(py::repr(given)) +
                       ", which is not what it is to give; its docstring in ddapath says that");
}

}  // namespace dda::python
