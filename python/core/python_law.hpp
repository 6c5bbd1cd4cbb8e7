#pragma once

#include <memory>

#include "models/interface/law.hpp"
#include "models/interface/softening/softening_shape.hpp"
#include "python/core/asked.hpp"

namespace dda::python {

/// The curve of a softening law, as a class of Python describes it: ddapath.SofteningCurve.
std::unique_ptr<SofteningShape> python_shape(pybind11::object curve);

/// A law of an interface in Python: ddapath.InterfaceLaw. `memory` is what it remembers of a point.
std::unique_ptr<InterfaceLaw> python_law(pybind11::object law, std::vector<Remembered> memory);

}  // namespace dda::python
