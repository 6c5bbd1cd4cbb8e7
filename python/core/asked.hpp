#pragma once

#include <pybind11/pybind11.h>

#include <cmath>
#include <type_traits>
#include <utility>

namespace dda::python {

/// An object of Python that any thread may ask and let go of. (What has members of pybind11 is seen here alone.)
class __attribute__((visibility("hidden"))) Asked {
 public:
  explicit Asked(pybind11::object object) : object_(std::move(object)) {}
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  ~Asked() {
    const pybind11::gil_scoped_acquire lock;
    object_ = {};
  }

  /// The value of a method. What it raises is thrown as pybind11::error_already_set, for whoever called the program.
  template <class Value, class... Arguments>
  Value ask(const char* method, Arguments&&... arguments) const {
    const pybind11::gil_scoped_acquire lock;
    return value<Value>(object_.attr(method)(std::forward<Arguments>(arguments)...), method);
  }
  const pybind11::object& object() const { return object_; }
  /// Throws pybind11::type_error that names the class and the method for a value of another type, and for nan.
  template <class Value>
  Value value(const pybind11::object& given, const char* method) const {
    Value out;
    try {
      out = given.cast<Value>();
    } catch (const pybind11::cast_error&) {
      wrong_type(given, method);
    }
    if constexpr (std::is_floating_point_v<Value>)
      if (std::isnan(out)) wrong_type(given, method);
    return out;
  }
  [[noreturn]] void wrong_type(const pybind11::handle& given, const char* method) const;

 private:
  pybind11::object object_;
};

}  // namespace dda::python
