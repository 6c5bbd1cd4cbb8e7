#include "framework/base/errors.hpp"

#include "python/core/bindings.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;

constexpr int wrong_input = 2, no_output = 4;

/// (place, what) of each.
py::list list_of(const std::vector<Finding>& findings) {
  py::list out;
  for (const Finding& finding : findings) out.append(py::make_tuple(to_string(finding.where), finding.what));
  return out;
}

/// Raises ddapath.errors.<name>(message, exit code, message), with `findings` if there are any.
void raise(const char* name, const std::exception& error, int code, const std::vector<Finding>& findings) {
  const py::object type = py::module_::import("ddapath.errors").attr(name);
  const py::object raised = type(error.what(), code, error.what());
  raised.attr("findings") = list_of(findings);
  PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(std::exception_ptr pending) {
  try {
    if (pending) std::rethrow_exception(pending);
  } catch (const InputError& error) {
    raise("InputError", error, wrong_input, error.findings());
  } catch (const OutputError& error) {
    raise("OutputError", error, no_output, {});
  }
}

}  // namespace

void bind_errors() { py::register_exception_translator(translate); }

}  // namespace dda::python
