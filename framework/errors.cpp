#include "framework/errors.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace dda {

namespace {

std::string line_of(const Finding& finding) {
  const std::string where = to_string(finding.where);
  return where.empty() ? finding.what : where + ": " + finding.what;
}

std::string text_of(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) text += (text.empty() ? "" : "\n") + line_of(finding);
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
  throw InputError(std::move(sorted));
}

}  // namespace dda
