#include "framework/deck/schema.hpp"

#include <algorithm>
#include <stdexcept>

#include "framework/base/suggestion.hpp"

namespace dda {

namespace {

std::string in_context(const Reading& reading) {
  return reading.context.empty() ? "" : " in " + reading.context;
}

/// "(number in F/L², above 0)": what the user should have written.
std::string described(const KindInfo& kind) {
  std::string text = kind.words();
  if (kind.dimension != dimension::none) text += " in " + label(kind.dimension);
  if (!kind.bounds.words().empty()) text += ", " + kind.bounds.words();
  return "(" + text + ")";
}

/// "; or `gauges: {drift: ...}`": what an unknown name may be, beside a number, where a section has a map of numbers.
std::string as_entry(const std::vector<Parameter>& parameters, const NodeEntry& entry) {
  const auto of_numbers = std::ranges::find_if(parameters, [](const Parameter& p) {
    return p.kind.form == KindInfo::Form::map && p.kind.item && p.kind.item->form == KindInfo::Form::number;
  });
  if (!entry.value.is_scalar() || of_numbers == parameters.end()) return "";
  return "; or `" + of_numbers->name + ": {" + entry.key + ": ...}`";
}

}  // namespace

std::vector<Parameter> SchemaBase::parameters() const {
  std::vector<Parameter> list;
  for (const Field& field : fields_) list.push_back(field.parameter);
  return list;
}

bool SchemaBase::has_required() const {
  return std::any_of(fields_.begin(), fields_.end(),
                     [](const Field& f) { return f.parameter.is_required(); });
}

void SchemaBase::declare(Field field) {
  for (const Field& other : fields_)
    if (other.parameter.name == field.parameter.name)
      throw std::logic_error("parameter '" + field.parameter.name + "' is declared twice");
  fields_.push_back(std::move(field));
}

bool SchemaBase::read_into(void* target, const Node& node, const Reading& reading) const {
  if (!node.is_map()) {
    expected("a map of parameters", node, reading);
    return false;
  }
  if (set_where_) set_where_(target, node.where);
  bool is_right = reject_unknown(node, reading);
  for (const Field& field : fields_) is_right = read_field(field, target, node, reading) && is_right;
  return is_right && run_checks(target, node.where, reading.findings);
}

bool SchemaBase::read_field(const Field& field, void* target, const Node& node,
                            const Reading& reading) const {
  const Parameter& parameter = field.parameter;
  const Reading inner = reading.at(parameter.name).in("section '" + parameter.name + "'");
  const Node* value = node.find(parameter.name);
  if (parameter.may_be_absent && (!value || value->is_null())) return true;
  if (value) return field.read(target, *value, inner);
  if (parameter.fallback) {
    Node fallback = *parameter.fallback;
    fallback.where = node.where;
    return field.read(target, fallback, inner);
  }
  reading.findings.add(node.where, "missing parameter '" + parameter.name + "'" + in_context(reading) + " " +
                                       described(parameter.kind));
  return false;
}

bool SchemaBase::reject_unknown(const Node& node, const Reading& reading) const {
  std::vector<std::string> names;
  for (const Field& field : fields_) names.push_back(field.parameter.name);
  bool is_right = true;
  for (const NodeEntry& entry : node.entries) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    is_right = false;
    std::string near = suggest(entry.key, names);
    if (near.starts_with("; known")) near += as_entry(parameters(), entry);
    reading.findings.add(entry.where, "unknown parameter '" + entry.key + "'" + in_context(reading) + near);
  }
  return is_right;
}

bool SchemaBase::run_checks(const void* target, const Position& where, Findings& findings) const {
  const std::size_t before = findings.size();
  for (const auto& check : checks_) check(target, where, findings);
  return findings.size() == before;
}

Node SchemaBase::echo_from(const void* source) const {
  Node node = Node::map();
  for (const Field& field : fields_)
    if (auto value = field.echo(source)) node.set(field.parameter.name, std::move(*value));
  return node;
}

}  // namespace dda
