#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/deck/family.hpp"

namespace dda::python {

// Classes of Python as members of the program's families: laws, loads, controls.

/// A parameter as a class of Python declares it: ddapath.Number.
struct OwnNumber {
  std::string name, text;
  Dimension dimension;
  std::optional<double> fallback, above, at_least, below, at_most;

  friend bool operator==(const OwnNumber&, const OwnNumber&) = default;
};

/// A class as it is registered. Its shape, what must stay beside the numbers, and these stay; the class may be replaced by
/// another one.
struct __attribute__((visibility("hidden"))) OwnClass {
  std::string shape;
  std::vector<OwnNumber> numbers;
  pybind11::object type;

  bool has_same_parameters(const OwnClass& other) const {
    return shape == other.shape && numbers == other.numbers;
  }
  /// An object of the class with the numbers of the deck. The lock must be held.
  pybind11::object object(const std::map<std::string, double>& own) const;
};

/// Of a class with `declared_numbers()`.
OwnClass own_class(const pybind11::object& type, std::string shape = "");

/// What a deck gives: numbers that the class declares.
struct OwnParameters {
  std::map<std::string, double> own;
  Position where;
};

/// A schema to which numbers are added by name, their values kept in `own` of the parameters.
template <class Parameters>
class OwnSchema final : public Schema<Parameters> {
 public:
  explicit OwnSchema(Schema<Parameters> others) : Schema<Parameters>(std::move(others)) {}

  void add(const OwnNumber& number) {
    const Kind<double> kind = number_kind(number.dimension, bounds_of(number));
    std::optional<Node> fallback;
    if (number.fallback) fallback = Node::number(*number.fallback);
    const auto read = [kind, name = number.name](void* object, const Node& node, const Reading& reading) {
      const std::optional<double> value = kind.read(node, reading);
      if (value) static_cast<Parameters*>(object)->own[name] = *value;
      return value.has_value();
    };
    const auto echo = [name = number.name](const void* object) -> std::optional<Node> {
      return Node::number(static_cast<const Parameters*>(object)->own.at(name));
    };
    this->declare({Parameter{number.name, number.text, kind.info, std::move(fallback), false}, read, echo});
  }

 private:
  static Bounds bounds_of(const OwnNumber& number) {
    Bounds out;
    if (number.above) out = out & above(*number.above);
    if (number.at_least) out = out & at_least(*number.at_least);
    if (number.below) out = out & below(*number.below);
    if (number.at_most) out = out & at_most(*number.at_most);
    return out;
  }
};

/// Registers a class under a name, with its numbers beside the other parameters; make(class, parameters, context...) builds
/// what a deck chooses. Under the same name a class with the same parameters replaces the earlier one. Throws
/// pybind11::value_error for other parameters, and for a name of the program's.
template <class Parameters, class OfFamily, class Make>
void register_own(OfFamily& family, const std::string& name, OwnClass given, const Schema<Parameters>& others,
                  Make make) {
  // It lives as long as the process, since classes must not be let go when Python has ended.
  static auto* registered = new std::map<std::string, std::shared_ptr<OwnClass>>;
  if (const auto found = registered->find(name); found != registered->end()) {
    if (!found->second->has_same_parameters(given))
      throw pybind11::value_error(
          family.name() + " '" + name +
          "' is registered with other parameters, which stay as long as this process: choose "
          "another name, or start Python again");
    found->second->type = given.type;
    return;
  }
  if (family.find(name))
    throw pybind11::value_error(family.name() + " '" + name +
                                "' is one of the program's or of a plugin: choose another name");
  auto shared = std::make_shared<OwnClass>(std::move(given));
  OwnSchema<Parameters> schema(others);
  for (const OwnNumber& number : shared->numbers) schema.add(number);
  family.add(name, static_cast<const Schema<Parameters>&>(schema),
             [shared, make](const Parameters& parameters, const auto&... context) {
               return make(*shared, parameters, context...);
             });
  registered->emplace(name, std::move(shared));
}

}  // namespace dda::python
