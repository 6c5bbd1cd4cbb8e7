#include "python/core/own_classes.hpp"

#include <pybind11/stl.h>

namespace dda::python {

namespace py = pybind11;

namespace {

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

}  // namespace

py::object OwnClass::object(const std::map<std::string, double>& own) const {
  py::dict given;
  for (const auto& [name, value] : own) given[py::str(name)] = value;
  return type(**given);
}

OwnClass own_class(const py::object& type, std::string shape) {
  OwnClass out{.shape = std::move(shape), .numbers = {}, .type = type};
  for (const py::handle number : type.attr("declared_numbers")()) out.numbers.push_back(number_of(number));
  return out;
}

}  // namespace dda::python
