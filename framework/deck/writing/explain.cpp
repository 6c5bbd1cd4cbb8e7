#include "framework/deck/writing/explain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/base/suggestion.hpp"
#include "framework/deck/family.hpp"

namespace dda {

namespace {

using Parts = std::vector<std::string>;

Parts split(const std::string& path) {
  Parts parts(1);
  for (char c : path) {
    if (c == '/' || c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  std::erase(parts, "");
  return parts;
}

const FamilyBase* find_family(const std::string& name) {
  for (const FamilyBase* family : all_families())
    if (family->name() == name) return family;
  return nullptr;
}

[[noreturn]] void unknown(const std::string& name, const std::vector<std::string>& names) {
  throw InputError(Position{}, "nothing is known of '" + name + "'" + suggest(name, names));
}

/// What a list or map is made of in the end.
const KindInfo& innermost(const KindInfo& kind) { return kind.item ? innermost(*kind.item) : kind; }

/// Names of the same width, each with its line.
std::string table(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::size_t width = 0;
  for (const auto& [name, line] : rows) width = std::max(width, name.size());
  std::string text;
  for (const auto& [name, line] : rows) text += fmt::format("  {:<{}}  {}\n", name, width, line);
  return text;
}

std::string default_words(const Parameter& parameter) {
  if (parameter.may_be_absent) return "may be left out";
  if (!parameter.fallback) return "required";
  if (parameter.fallback->is_null() || (parameter.fallback->is_map() && parameter.fallback->entries.empty()))
    return "may be left out";
  std::string text = to_yaml(*parameter.fallback);
  return "default " + text.substr(0, text.size() - 1);
}

}  // namespace

std::string facts(const Parameter& parameter, const Units& units) {
  const KindInfo& kind = innermost(parameter.kind);
  std::string text = parameter.kind.words();
  if (kind.dimension != dimension::none) text += " [" + label(kind.dimension, units) + "]";
  if (!kind.bounds.words().empty()) text += ", " + kind.bounds.words();
  if (parameter.kind.at_least > 0) text += fmt::format(", at least {}", parameter.kind.at_least);
  return text + ", " + default_words(parameter);
}

namespace {

std::string parameter_lines(const Parameter& parameter, const Units& units) {
  return fmt::format("  {}: {}\n      {}\n", parameter.name, facts(parameter, units), parameter.text);
}

std::string schema_lines(const SchemaBase& schema, const Units& units) {
  std::string text = schema.text() + "\n\n";
  for (const Parameter& parameter : schema.parameters()) text += parameter_lines(parameter, units);
  return schema.parameters().empty() ? schema.text() + "\n\n  It has no parameters.\n" : text;
}

std::string family_lines(const FamilyBase& family) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const FamilyMember* member : family.entries()) rows.emplace_back(member->name, member->schema->text());
  return fmt::format("{}: {}\n\n{}", family.name(), family.text(), table(rows));
}

std::string in_schema(const SchemaBase& schema, Parts parts, const Units& units);

std::string in_family(const FamilyBase& family, Parts parts, const Units& units) {
  if (parts.empty()) return family_lines(family);
  const FamilyMember* member = family.find(parts[0]);
  std::vector<std::string> names;
  for (const FamilyMember* entry : family.entries()) names.push_back(entry->name);
  if (!member) unknown(parts[0], names);
  parts.erase(parts.begin());
  const std::string title = parts.empty() ? family.name() + " " + member->name + ": " : "";
  return title + in_schema(*member->schema, std::move(parts), units);
}

Parameter find_parameter(const SchemaBase& schema, const std::string& name, std::vector<std::string> others) {
  for (const Parameter& parameter : schema.parameters()) {
    if (parameter.name == name) return parameter;
    others.push_back(parameter.name);
  }
  unknown(name, others);
}

std::string in_schema(const SchemaBase& schema, Parts parts, const Units& units) {
  if (parts.empty()) return schema_lines(schema, units);
  const Parameter parameter = find_parameter(schema, parts[0], {});
  const KindInfo& kind = innermost(parameter.kind);
  const std::string own = parts.size() == 1 ? parameter_lines(parameter, units) + "\n" : "";
  parts.erase(parts.begin());
  if (kind.section) return own + in_schema(*kind.section, std::move(parts), units);
  if (kind.family) return own + in_family(*kind.family, std::move(parts), units);
  if (!parts.empty()) unknown(parts[0], {});
  return own;
}

/// With all topics to choose from: where none is near, the members of families would be too many to list.
[[noreturn]] void refuse_topic(const SchemaBase& deck, const std::string& name,
                               std::vector<std::string> others) {
  std::vector<std::string> members = others;
  for (const FamilyBase* family : all_families())
    for (const FamilyMember* member : family->entries()) members.push_back(member->name);
  for (const Parameter& parameter : deck.parameters()) members.push_back(parameter.name);
  const std::string near = suggest(name, members);
  if (near.starts_with("; did you mean"))
    throw InputError(Position{}, "nothing is known of '" + name + "'" + near);
  find_parameter(deck, name, std::move(others));
  unknown(name, {});
}

std::string overview(const SchemaBase& deck) {
  std::vector<std::pair<std::string, std::string>> sections, families;
  for (const Parameter& parameter : deck.parameters()) sections.emplace_back(parameter.name, parameter.text);
  for (const FamilyBase* family : all_families()) families.emplace_back(family->name(), family->text());
  return deck.text() + "\n\nSections of a deck:\n" + table(sections) + "\nFamilies:\n" + table(families) +
         "\nMore: dda explain SECTION, dda explain FAMILY, dda explain NAME, of a member of whatever "
         "family\n";
}

}  // namespace

std::string explain(const SchemaBase& deck, const std::string& path, const Units& units,
                    std::vector<std::string> others) {
  Parts parts = split(path);
  if (parts.empty()) return overview(deck);
  const auto parameters = deck.parameters();
  const bool is_section = std::any_of(parameters.begin(), parameters.end(),
                                      [&](const Parameter& p) { return p.name == parts[0]; });
  const FamilyBase* family = find_family(parts[0]);
  const bool is_member = family && parts.size() > 1 && family->find(parts[1]);
  if (is_section && !is_member) return in_schema(deck, std::move(parts), units);
  if (family) return in_family(*family, Parts(parts.begin() + 1, parts.end()), units);
  std::string members;  // of whatever family
  for (const FamilyBase* known : all_families()) {
    if (known->find(parts[0])) members += (members.empty() ? "" : "\n") + in_family(*known, parts, units);
    others.push_back(known->name());
  }
  if (members.empty()) refuse_topic(deck, parts[0], std::move(others));
  return members;
}

}  // namespace dda
