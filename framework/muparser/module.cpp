#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "framework/deck/expression/expression.hpp"

namespace dda {
namespace muparser {
namespace {

/// muParser with what the deck's manual says of expressions.
mu::Parser fresh_parser() {
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineFun(
      "floor", +[](double x) { return std::floor(x); });
  parser.DefineFun(
      "ceil", +[](double x) { return std::ceil(x); });
  return parser;
}

class Parsed final : public Expression {
 public:
  Parsed(const std::string& text, const std::vector<std::string>& arguments)
      : parser_(fresh_parser()), values_(arguments.size()) {
    for (std::size_t i = 0; i < arguments.size(); ++i) parser_.DefineVar(arguments[i], &values_[i]);
    parser_.SetExpr(text);
  }
  void define(const std::string& name, double value) { parser_.DefineConst(name, value); }
  /// Makes muParser look at the text; how many values it found, separated by commas.
  int num_results() {
    parser_.Eval();
    return parser_.GetNumResults();
  }
  double value(std::span<const double> arguments) const override {
    std::ranges::copy(arguments, values_.begin());
    return parser_.Eval();
  }

 private:
  mu::Parser parser_;
  mutable std::vector<double> values_;
};

/// Where a single '=' stands: muParser would assign.
std::optional<std::size_t> assignment_in(const std::string& text) {
  const auto is_one_of = [](char c, std::string_view signs) {
    return signs.find(c) != std::string_view::npos;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool is_second = i > 0 && is_one_of(text[i - 1], "<>!=");
    const bool is_first = i + 1 < text.size() && text[i + 1] == '=';
    if (!is_second && !is_first) return i;
  }
  return {};
}

bool begins_like_name(const std::string& token) {
  return !token.empty() && (std::isalpha(static_cast<unsigned char>(token[0])) != 0 || token[0] == '_');
}

bool is_before_parenthesis(const std::string& text, std::size_t end) {
  const std::size_t next = text.find_first_not_of(' ', end);
  return next != std::string::npos && text[next] == '(';
}

/// What muParser says, without its own count of places.
std::string words(const mu::ParserError& error) {
  std::string text = error.GetMsg();
  if (const auto place = text.find(" found at position"); place != std::string::npos) text.erase(place);
  if (const auto place = text.find(" at position"); place != std::string::npos) text.erase(place);
  while (!text.empty() && text.back() == '.') text.pop_back();
  if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

ExpressionFault fault_of(const mu::ParserError& error, const std::string& text) {
  const int found = error.GetPos();
  const std::size_t at = std::min(static_cast<std::size_t>(std::max(found, 0)), text.size());
  const std::string token = error.GetToken();
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && begins_like_name(token))
    return {"", at, token, is_before_parenthesis(text, at + token.size())};
  if (error.GetCode() == mu::ecMISSING_PARENS &&
      std::ranges::count(text, '(') > std::ranges::count(text, ')'))
    return {
        "a parenthesis is open; an expression with commas stands in quotes, as a comma ends it in {} and []",
        text.find('('), "", false};
  if (text.find("**") != std::string::npos) return {"powers are written with ^", text.find("**"), "", false};
  return {words(error), at, "", false};
}

/// muParser stops at each name that it does not know; then the name is defined and it looks again.
CompiledExpression compile(const std::string& text, const std::vector<std::string>& arguments,
                           const NameLookup& lookup) {
  if (const auto at = assignment_in(text))
    return ExpressionFault{"nothing is assigned; == compares", *at, "", false};
  const auto out = std::make_shared<Parsed>(text, arguments);
  for (;;) {
    try {
      if (out->num_results() == 1) return out;
      return ExpressionFault{"the decimal sign is a point, and a comma separates the arguments of a function",
                             text.find(','), "", false};
    } catch (const mu::ParserError& error) {
      ExpressionFault fault = fault_of(error, text);
      const std::optional<double> value = fault.name.empty() ? std::nullopt : lookup(fault.name);
      if (!value) return fault;
      out->define(fault.name, *value);
    }
  }
}

template <class Names>
std::vector<std::string> keys(const Names& names) {
  std::vector<std::string> out;
  for (const auto& [name, what] : names) out.push_back(name);
  return out;
}

std::vector<std::string> functions() { return keys(fresh_parser().GetFunDef()); }
std::vector<std::string> constants() { return keys(fresh_parser().GetConst()); }

}  // namespace
}  // namespace muparser
}  // namespace dda

/// The module's one symbol, looked up by name in framework/deck/expression/expression.cpp.
extern "C" const dda::ExpressionModule dda_muparser_module;
const dda::ExpressionModule dda_muparser_module{&dda::muparser::compile, &dda::muparser::functions,
                                                &dda::muparser::constants};
