#pragma once

#include <pybind11/pybind11.h>

namespace dda::python {

/// InputError and OutputError become the exceptions of the same names in ddapath.errors.
void bind_errors();
/// Registration of laws that are classes of Python.
void bind_laws(pybind11::module_& module);
/// Of loads and of controls.
void bind_loads(pybind11::module_& module);
void bind_controls(pybind11::module_& module);
/// Paths that are followed point by point.
void bind_followed(pybind11::module_& module);

}  // namespace dda::python
