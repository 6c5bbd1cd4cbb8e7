#include "framework/deck/expression/variables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

std::vector<std::string> names_for_expressions(const std::string& word) {
  const auto& functions = functions_of_expressions();
  const auto& constants = constants_of_expressions();
  if (std::ranges::find(functions, word) != functions.end()) return {"function"};
  if (std::ranges::find(constants, word) != constants.end()) return {"constant"};
  return {};
}

std::optional<double> plain_number(const Node& node) {
  double value = 0;
  const char* end = node.text.data() + node.text.size();
  const auto result = std::from_chars(node.text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value) ? std::optional(value)
                                                                               : std::nullopt;
}

}  // namespace

Position position_in(const Node& scalar, std::size_t at) {
  Position out = scalar.where;
  if (out.line == 0) return out;
  const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  const auto end = scalar.text.begin() + static_cast<std::ptrdiff_t>(std::min(at, scalar.text.size()));
  out.column +=
      static_cast<int>(std::count_if(scalar.text.begin(), end, is_first_byte)) + (scalar.quoted ? 1 : 0);
  return out;
}

void collect_names(const Node& node, std::set<std::string>& out) {
  if (node.is_scalar())
    for (NameInText& found : names_in(node.text)) out.insert(std::move(found.name));
  for (const Node& item : node.items) collect_names(item, out);
  for (const NodeEntry& entry : node.entries) collect_names(entry.value, out);
}

Variables::Variables(const Node& section, Findings& findings) : findings_(&findings) {
  if (section.is_null()) return;
  if (!section.is_map()) findings.add(section.where, "variables: expected a map from names to numbers");
  for (const NodeEntry& entry : section.entries) {
    if (!is_name(entry.key))
      findings.add(
          entry.where,
          fmt::format("variables: '{}' is no name: letters, digits and _, no digit first", entry.key));
    else if (const auto taken = names_for_expressions(entry.key); !taken.empty())
      findings.add(entry.where, fmt::format("variables: '{}' is a {} of expressions; choose another name",
                                            entry.key, taken[0]));
    else
      entries_[entry.key] = {entry.where, entry.value};
  }
}

std::string Variables::unknown(const ExpressionFault& fault) const {
  if (fault.is_call)
    return fmt::format("'{}' is no function{}", fault.name, suggest(fault.name, functions_of_expressions()));
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries_) names.push_back(name);
  return fmt::format("'{}' is no variable{}", fault.name, names.empty() ? "" : suggest(fault.name, names));
}

Variables::Failure Variables::failure_of(const ExpressionFault& fault, const Node& node) const {
  if (fault.name.empty()) return {position_in(node, fault.at), fault.what};
  if (!fault.is_call && has(fault.name)) return {node.where, "", true};
  return {position_in(node, fault.at), unknown(fault)};
}

Variables::Compiled Variables::compile(const Node& node, const std::vector<std::string>& arguments) {
  for (const NameInText& found : names_in(node.text))
    if (has(found.name) && std::ranges::find(arguments, found.name) != arguments.end())
      return Failure{position_in(node, found.at),
                     fmt::format("'{}' is a coordinate here; call the variable otherwise", found.name)};
  auto compiled = dda::compile(node.text, arguments, [this](const std::string& name) { return value(name); });
  if (const auto* fault = std::get_if<ExpressionFault>(&compiled)) return failure_of(*fault, node);
  return std::get<0>(std::move(compiled));
}

std::string Variables::resolved(const Node& node, const std::vector<std::string>& arguments) {
  std::string out = node.text;
  std::vector<NameInText> names = names_in(node.text);
  std::ranges::reverse(names);
  for (const auto& [at, name] : names) {
    if (!has(name) || std::ranges::find(arguments, name) != arguments.end()) continue;
    const std::string number = Node::number(value(name).value_or(0)).text;
    out.replace(at, name.size(), number.starts_with('-') ? "(" + number + ")" : number);
  }
  return out;
}

std::optional<double> Variables::value(const std::string& name) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return {};
  Entry& entry = found->second;
  entry.is_used = true;
  if (entry.state == State::being_read) {
    const auto first = std::ranges::find(reading_, name);
    const std::string way = fmt::format("{}", fmt::join(first, reading_.end(), " → "));
    fail(entry, entry.where, fmt::format("variables: {} → {} is a circle", way, name));
  }
  if (entry.state == State::unread) read(name, entry);
  return entry.state == State::right ? std::optional(entry.value) : std::nullopt;
}

void Variables::read(const std::string& name, Entry& entry) {
  if (!entry.node.is_scalar())
    return fail(entry, entry.node.where,
                fmt::format("variables.{}: expected a number or an expression", name));
  if (const auto number = plain_number(entry.node)) {
    entry.value = *number;
    entry.state = State::right;
    return;
  }
  entry.state = State::being_read;
  reading_.push_back(name);
  const Compiled compiled = compile(entry.node);
  reading_.pop_back();
  if (entry.state == State::wrong) return;
  if (const auto* failure = std::get_if<Failure>(&compiled)) {
    if (failure->is_told)
      entry.state = State::wrong;
    else
      fail(entry, failure->where, fmt::format("variables.{}: {}", name, failure->what));
    return;
  }
  entry.value = std::get<0>(compiled)->value({});
  entry.state = State::right;
  if (!std::isfinite(entry.value))
    fail(entry, entry.node.where,
         fmt::format("variables.{}: '{}' is no finite number", name, entry.node.text));
}

void Variables::fail(Entry& entry, const Position& where, const std::string& what) {
  entry.state = State::wrong;
  findings_->add(where, what);
}

std::map<std::string, double> Variables::values() {
  std::map<std::string, double> out;
  for (auto& [name, entry] : entries_) {
    if (entry.state == State::unread) read(name, entry);
    if (entry.state == State::right) out[name] = entry.value;
  }
  return out;
}

void Variables::refuse_unused(const std::set<std::string>& excused, Findings& findings) const {
  std::vector<std::string> used;
  for (const auto& [name, entry] : entries_)
    if (entry.is_used) used.push_back(name);
  for (const auto& [name, entry] : entries_)
    if (!entry.is_used && !excused.contains(name))
      findings.add(entry.where, fmt::format("variables: '{}' is used nowhere{}", name,
                                            used.empty() ? "" : suggest(name, used)));
}

}  // namespace dda
