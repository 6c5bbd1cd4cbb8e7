#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace dda {

/// An arithmetic expression of some arguments, such as `rho*g*(H - y)` of (x, y). Not for several threads at once.
class Expression {
 public:
  Expression() = default;
  virtual ~Expression() = default;
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// As many arguments as it was compiled with, in their order. May be infinite or not a number.
  virtual double value(std::span<const double> arguments) const = 0;
};

/// What is wrong with an expression.
struct ExpressionFault {
  std::string what;
  std::size_t at = 0;    ///< in its text, from 0
  std::string name;      ///< that nothing is known of; "" for what else is wrong
  bool is_call = false;  ///< whether that name stands before a parenthesis
};

/// The value of a name that is neither argument nor function; nothing when there is none.
using NameLookup = std::function<std::optional<double>(const std::string&)>;
using CompiledExpression = std::variant<std::shared_ptr<const Expression>, ExpressionFault>;

/// Numbers, names, + - * / ^, comparisons, `a > b ? c : d`, and functions: see `functions_of_expressions`. Names
/// are replaced by their values once and for all; nothing is assigned.
CompiledExpression compile(const std::string& text, const std::vector<std::string>& arguments,
                           const NameLookup& lookup);

/// sin, sqrt, min, ..., and the constants (pi), sorted.
const std::vector<std::string>& functions_of_expressions();
const std::vector<std::string>& constants_of_expressions();

/// A name in an expression's text.
struct NameInText {
  std::size_t at = 0;
  std::string name;
};

/// Every word of a text that may be a name, in order; the exponent of a number is none.
std::vector<NameInText> names_in(const std::string& text);

/// Whether a word may name a variable: letters, digits and '_', no digit first.
bool is_name(const std::string& word);

/// What the module of muParser gives out under the symbol `dda_muparser_module`. It is loaded with the first
/// expression: most decks have none.
struct ExpressionModule {
  CompiledExpression (*compile)(const std::string&, const std::vector<std::string>&, const NameLookup&);
  std::vector<std::string> (*functions)();
  std::vector<std::string> (*constants)();
};

}  // namespace dda
