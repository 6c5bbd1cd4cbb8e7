#include "studies/dda/sweep/description/derived_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "framework/base/suggestion.hpp"
#include "framework/deck/changes/settings.hpp"
#include "studies/dda/run/recording/summary.hpp"

namespace dda {
namespace {

constexpr std::string_view of_gauges = "peak.gauges.";

bool is_inside_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

/// A text whose dotted names have been replaced by arguments that an expression may have.
struct Undotted {
  std::string text;
  std::vector<std::string> names, arguments;

  void add(const std::string& name) {
    const auto found = std::ranges::find(names, name);
    const auto place = found - names.begin();
    if (found == names.end()) {
      names.push_back(name);
      arguments.push_back(fmt::format("number_{}", place));
    }
    text += arguments[static_cast<std::size_t>(place)];
  }
};

/// Functions, before a parenthesis, and constants stay.
Undotted undotted(const std::string& text) {
  Undotted out;
  for (std::size_t at = 0; at < text.size();) {
    if (const auto c = static_cast<unsigned char>(text[at]); std::isalpha(c) == 0 && c != '_') {
      const std::size_t number =
          std::isdigit(c) != 0 || c == '.' ? text.find_first_not_of("0123456789.eE", at) : at + 1;
      const std::size_t end = std::min(number, text.size());
      out.text += text.substr(at, end - at);
      at = end;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && is_inside_name(text[end])) ++end;
    const std::string name = text.substr(at, end - at);
    const std::size_t next = text.find_first_not_of(' ', end);
    const bool is_call = next != std::string::npos && text[next] == '(';
    if (is_call || std::ranges::find(constants_of_expressions(), name) != constants_of_expressions().end())
      out.text += name;
    else
      out.add(name);
    at = end;
  }
  return out;
}

std::optional<double> number_of(const Node* node) {
  if (!node || !node->is_scalar()) return {};
  const Json json = to_json(*node);
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

/// Of the varied key of that name, or the only one that ends with it.
const Node* find_varied(const std::string& name, const std::vector<std::pair<std::string, Node>>& varied) {
  const Node* found = nullptr;
  for (const auto& [key, value] : varied) {
    if (key == name) return &value;
    if (!key.ends_with("." + name)) continue;
    if (found) return nullptr;
    found = &value;
  }
  return found;
}

bool is_of_summary(const std::string& name, const Node& deck) {
  if (std::ranges::find(numbers_of_summaries, name) != numbers_of_summaries.end()) return true;
  const Node* gauges = deck.find("gauges");
  return name.starts_with(of_gauges) && gauges && gauges->find(name.substr(of_gauges.size()));
}

/// Names of gauges may have dots of their own.
std::optional<double> number_of(const Json& summary, const std::string& name) {
  std::vector<std::string> keys;
  if (name.starts_with(of_gauges)) {
    keys = {"peak", "gauges", name.substr(of_gauges.size())};
  } else {
    std::istringstream parts(name);
    for (std::string key; std::getline(parts, key, '.');) keys.push_back(key);
  }
  const Json* at = &summary;
  for (const std::string& key : keys) {
    if (!at->is_object() || !at->contains(key)) return {};
    at = &at->at(key);
  }
  return at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
}

std::optional<double> number_of(const std::string& name, const CaseNumbers& numbers) {
  if (const auto number = number_of(find_varied(name, numbers.varied))) return number;
  if (const auto known = numbers.variables.find(name); known != numbers.variables.end()) return known->second;
  return number_of(find_value(numbers.effective_deck, name));
}

}  // namespace

std::vector<std::string> reserved_columns() {
  std::vector<std::string> out{"case",
                               "folder",
                               "status",
                               "exit_code",
                               "reason",
                               "title",
                               "stop",
                               "cracked_steps",
                               "whole_steps",
                               "newton_iterations",
                               "whole_iterations",
                               "reduced_iterations",
                               "relaxation_iterations",
                               "factorisations",
                               "multiplier_iterations",
                               "largest_gap",
                               "mesh_bias",
                               "energy_balance_scatter",
                               "threads",
                               "version"};
  for (const std::string_view name : numbers_of_summaries)
    if (is_name(std::string(name))) out.emplace_back(name);
  return out;
}

std::vector<DerivedColumn> read_derived_columns(const Node& columns, Findings& findings) {
  std::vector<DerivedColumn> out;
  const std::vector<std::string> taken = reserved_columns();
  if (!columns.is_map()) {
    findings.add(columns.where,
                 "columns: expected a map from names to expressions, such as strength: peak.load/thickness");
    return out;
  }
  for (const NodeEntry& entry : columns.entries) {
    if (!entry.value.is_scalar()) {
      findings.add(entry.where, fmt::format("columns.{}: expected an expression", entry.key));
      continue;
    }
    if (!is_name(entry.key)) {
      findings.add(entry.where, fmt::format("columns.{}: a name is of letters, digits and _", entry.key));
      continue;
    }
    if (std::ranges::find(taken, entry.key) != taken.end()) {
      findings.add(entry.where,
                   fmt::format("columns.{}: sweep.csv has a column of that name; give another", entry.key));
      continue;
    }
    const Undotted read = undotted(entry.value.text);
    const auto compiled = compile(read.text, read.arguments, [](const std::string&) { return std::nullopt; });
    if (const auto* fault = std::get_if<ExpressionFault>(&compiled))
      findings.add(entry.value.where,
                   fmt::format("columns.{}: {}{}", entry.key, fault->what,
                               fault->is_call ? suggest(fault->name, functions_of_expressions()) : ""));
    else
      out.push_back({entry.key, entry.where, read.names, std::get<0>(compiled)});
  }
  return out;
}

std::vector<std::vector<std::optional<double>>> known_numbers(const std::vector<DerivedColumn>& columns,
                                                              const CaseNumbers& numbers,
                                                              Findings& findings) {
  std::vector<std::vector<std::optional<double>>> out;
  std::vector<std::string> names(numbers_of_summaries.begin(), numbers_of_summaries.end()), before;
  for (const auto& [key, value] : numbers.varied) names.push_back(key);
  for (const auto& [name, value] : numbers.variables) names.push_back(name);
  for (const DerivedColumn& column : columns) {
    out.emplace_back();
    for (const std::string& name : column.names) {
      out.back().push_back(number_of(name, numbers));
      if (out.back().back() || std::ranges::find(before, name) != before.end() ||
          is_of_summary(name, numbers.effective_deck))
        continue;
      findings.add(column.where,
                   fmt::format("columns.{}: '{}' is no varied key, no variable or number of the deck, no "
                               "column before it and none of the summary{}",
                               column.name, name, suggest(name, names)));
    }
    before.push_back(column.name);
    names.push_back(column.name);
  }
  return out;
}

std::vector<std::optional<double>> values_of(const std::vector<DerivedColumn>& columns,
                                             const std::vector<std::vector<std::optional<double>>>& known,
                                             const Json& summary) {
  std::map<std::string, std::optional<double>> before;
  std::vector<std::optional<double>> out;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::vector<double> arguments;
    for (std::size_t i = 0; i < known[c].size(); ++i) {
      const std::string& name = columns[c].names[i];
      const auto earlier = before.find(name);
      std::optional<double> number = known[c][i];
      if (!number) number = earlier != before.end() ? earlier->second : number_of(summary, name);
      if (number) arguments.push_back(*number);
    }
    const bool is_whole = arguments.size() == known[c].size();
    const double value = is_whole ? columns[c].expression->value(arguments) : std::nan("");
    out.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
    before[columns[c].name] = out.back();
  }
  return out;
}

}  // namespace dda
