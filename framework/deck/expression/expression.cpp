#include "framework/deck/expression/expression.hpp"

#include <algorithm>
#include <cctype>

#include "framework/base/loaded.hpp"

namespace dda {
namespace {

const ExpressionModule& module() {
  static const auto* loaded = static_cast<const ExpressionModule*>(
      symbol_of(module_file("dda_muparser.so"), "dda_muparser_module"));
  return *loaded;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Behind the number that begins at `at`: 12, 1.5, 1e-3.
std::size_t end_of_number(const std::string& text, std::size_t at) {
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  if (at == text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
  std::size_t digits = at + 1;
  if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
  if (digits == text.size() || !is_digit(text[digits])) return at;
  while (digits < text.size() && is_digit(text[digits])) ++digits;
  return digits;
}

}  // namespace

CompiledExpression compile(const std::string& text, const std::vector<std::string>& arguments,
                           const NameLookup& lookup) {
  return module().compile(text, arguments, lookup);
}

const std::vector<std::string>& functions_of_expressions() {
  static const std::vector<std::string> names = module().functions();
  return names;
}

const std::vector<std::string>& constants_of_expressions() {
  static const std::vector<std::string> names = module().constants();
  return names;
}

std::vector<NameInText> names_in(const std::string& text) {
  std::vector<NameInText> out;
  for (std::size_t at = 0; at < text.size();) {
    if (is_digit(text[at]) || text[at] == '.') {
      at = std::max(at + 1, end_of_number(text, at));
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
    if (end > at) out.push_back({at, text.substr(at, end - at)});
    at = std::max(at + 1, end);
  }
  return out;
}

bool is_name(const std::string& word) {
  return !word.empty() && is_letter(word[0]) &&
         std::ranges::all_of(word, [](char c) { return is_letter(c) || is_digit(c); });
}

}  // namespace dda
