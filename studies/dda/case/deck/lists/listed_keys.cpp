#include "studies/dda/case/deck/lists/listed_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "framework/deck/changes/settings.hpp"

namespace dda {
namespace {

bool is_same(const Position& one, const Position& other) {
  return one.file == other.file && one.line == other.line && one.column == other.column;
}

/// Whether a finding is about a key: it begins with its name, and stands at its value or at its section.
bool is_about(const Finding& finding, const std::string& key, const Finding& parameter, const Node& root) {
  const std::size_t dot = key.rfind('.');
  if (!finding.what.starts_with(key.substr(dot + 1) + ":")) return false;
  const Node* section = find_value(root, key.substr(0, dot));
  return is_same(finding.where, parameter.where) || (section && is_same(finding.where, section->where));
}

}  // namespace

InputError said_by_lists(const InputError& error, const ListedKeys& listed, const Node& root) {
  std::vector<Finding> out = error.findings();
  for (Finding& finding : out) {
    const auto found = std::ranges::find_if(
        listed, [&](const auto& one) { return is_about(finding, one.first, one.second, root); });
    if (found == listed.end()) continue;
    const std::string said = finding.what.substr(finding.what.find(':'));
    finding = {found->second.where, fmt::format("{} ({}){}", found->second.what, found->first, said)};
  }
  return InputError(std::move(out));
}

}  // namespace dda
