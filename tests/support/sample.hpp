#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "framework/deck/family.hpp"
#include "support/random.hpp"

namespace dda {

/// What a schema cannot say of itself: texts that must name something of the scene, and optional parameters
/// that a rule across keys asks for; values by parameter.
using NameHints = std::map<std::string, std::string>;

inline double sample_number(const Bounds& bounds, Random& random) {
  const bool low = std::isfinite(bounds.low), high = std::isfinite(bounds.high);
  if (low && high) return bounds.low + random.between(0.1, 0.9) * (bounds.high - bounds.low);
  if (high) return bounds.high - random.between(0.5, 2);
  return (low ? bounds.low : 0) + random.between(0.5, 2);
}

/// A point inside the unit square, or a direction that is not zero.
inline Node sample_point(Dimension dimension, Random& random) {
  const bool place = dimension == dimension::length;
  const double x = place ? random.between(0.05, 0.95) : random.between(0.5, 2);
  const double y = place ? random.between(0.05, 0.95) : random.between(-2, -0.5);
  return Node::sequence({Node::number(x), Node::number(y)});
}

Node sample(const SchemaBase& schema, Random& random, const NameHints& names = {});

inline Node sample_value(const Parameter& parameter, Random& random, const NameHints& names) {
  using Form = KindInfo::Form;
  const KindInfo& kind = parameter.kind;
  if (const auto found = names.find(parameter.name); found != names.end()) return Node::scalar(found->second);
  switch (kind.form) {
    case Form::number:
      return Node::number(sample_number(kind.bounds, random));
    case Form::integer:
      return Node::integer(static_cast<std::int64_t>(std::ceil(sample_number(kind.bounds, random))));
    case Form::boolean:
      return Node::boolean(random.coin());
    case Form::name:
      return Node::scalar(kind.names.front());
    case Form::point:
    case Form::spot:
      return sample_point(kind.dimension, random);
    case Form::section:
      return sample(*kind.section, random, names);
    case Form::file:
      return Node::scalar("/proc/self/exe");  // which is always there
    case Form::list: {
      if (kind.item->form != Form::number) break;
      std::vector<Node> growing;  // from 0, as tables over something do
      for (std::size_t i = 0; i < std::max<std::size_t>(kind.at_least, 1); ++i)
        growing.push_back(Node::number(static_cast<double>(i)));
      return Node::sequence(std::move(growing));
    }
    default:
      break;
  }
  throw std::logic_error("no sample of the required parameter '" + parameter.name + "': extend " + __FILE__);
}

/// Admissible parameters: everything that is required, random values for every number and point with a
/// default, and a place `at`. What else may be absent is left out.
inline Node sample(const SchemaBase& schema, Random& random, const NameHints& names) {
  using Form = KindInfo::Form;
  Node out = Node::map();
  for (const Parameter& parameter : schema.parameters()) {
    const Form form = parameter.kind.form;
    const bool vary = (form == Form::number || form == Form::point) && !parameter.may_be_absent;
    const bool is_place = form == Form::spot && parameter.name == "at";
    const bool is_other_place = parameter.name == "boundary" && parameter.may_be_absent && out.find("at");
    if (parameter.is_required() || vary || is_place || (names.contains(parameter.name) && !is_other_place))
      out.set(parameter.name, sample_value(parameter, random, names));
  }
  return out;
}

/// Hints that give every number which may be absent a random value.
inline NameHints optional_numbers(const SchemaBase& schema, Random& random) {
  NameHints out;
  for (const Parameter& parameter : schema.parameters())
    if (parameter.may_be_absent && parameter.kind.form == KindInfo::Form::number)
      out[parameter.name] = Node::number(sample_number(parameter.kind.bounds, random)).text;
  return out;
}

/// The same quantities in other units: a force of 1 is now `force`, a length of 1 is `length`.
struct UnitChange {
  double force = 1, length = 1;
  double factor(Dimension d) const { return std::pow(force, d.force) * std::pow(length, d.length); }
};

Node rescaled(Node node, const SchemaBase& schema, const UnitChange& units);

/// A value of one kind rewritten in other units, as the declared dimensions say.
inline Node rescaled(Node node, const KindInfo& kind, const UnitChange& units) {
  using Form = KindInfo::Form;
  switch (kind.form) {
    case Form::number:
      return Node::number(units.factor(kind.dimension) * std::stod(node.text));
    case Form::point:
    case Form::spot:
      for (Node& item : node.items) item = Node::number(units.factor(kind.dimension) * std::stod(item.text));
      return node;
    case Form::section:
      return rescaled(std::move(node), *kind.section, units);
    case Form::family:
      if (!node.is_map()) return node;
      return rescaled(node, *kind.family->find(node.find("type")->text)->schema, units);
    case Form::list:
    case Form::map:
      for (Node& item : node.items) item = rescaled(std::move(item), *kind.item, units);
      for (NodeEntry& entry : node.entries) entry.value = rescaled(std::move(entry.value), *kind.item, units);
      return node;
    default:
      return node;
  }
}

/// The same for the parameters of a struct.
inline Node rescaled(Node node, const SchemaBase& schema, const UnitChange& units) {
  for (const Parameter& parameter : schema.parameters())
    if (Node* value = node.find(parameter.name)) *value = rescaled(*value, parameter.kind, units);
  return node;
}

/// Names of the members of a family, for parameterised tests.
inline std::vector<std::string> names_of(const FamilyBase& family) {
  std::vector<std::string> out;
  for (const FamilyMember* member : family.entries()) out.push_back(member->name);
  return out;
}

}  // namespace dda
