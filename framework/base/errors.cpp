#include "framework/base/errors.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace dda {

namespace {

/// What a terminal still shows of a broken file.
constexpr std::size_t most_lines = 30, longest_line = 2000;

std::string line_of(const Finding& finding) {
  const std::string where = to_string(finding.where);
  std::string line = where.empty() ? finding.what : where + ": " + finding.what;
  if (line.size() > longest_line) line = line.substr(0, longest_line) + " ...";
  return line;
}

std::string text_of(const std::vector<Finding>& findings) {
  std::string text;
  const std::size_t shown = std::min(findings.size(), most_lines);
  for (std::size_t i = 0; i < shown; ++i) text += (text.empty() ? "" : "\n") + line_of(findings[i]);
  if (shown < findings.size()) text += "\n... and " + std::to_string(findings.size() - shown) + " more";
  return text;
}

bool stands_before(const Finding& a, const Finding& b) {
  return std::tie(a.where.file, a.where.line, a.where.column) <
         std::tie(b.where.file, b.where.line, b.where.column);
}

}  // namespace

std::string to_string(const Position& where) {
  if (where.line == 0) return where.file;
  return where.file + ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
}

InputError::InputError(std::vector<Finding> findings)
    : std::runtime_error(text_of(findings)), findings_(std::move(findings)) {}

InputError::InputError(Position where, std::string what)
    : InputError(std::vector<Finding>{{std::move(where), std::move(what)}}) {}

void Findings::add(Position where, std::string what) { list_.push_back({std::move(where), std::move(what)}); }

void Findings::add(const InputError& error) {
  list_.insert(list_.end(), error.findings().begin(), error.findings().end());
}

void Findings::throw_if_any() const {
  if (list_.empty()) return;
  auto sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), stands_before);
  std::set<std::tuple<std::string, std::string>> seen;
  std::erase_if(sorted, [&](const Finding& finding) {
    return !seen.emplace(to_string(finding.where), finding.what).second;
  });
  throw InputError(std::move(sorted));
}

}  // namespace dda
