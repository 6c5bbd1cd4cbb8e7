#include "framework/deck/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "framework/deck/expression/reading_scope.hpp"
#include "framework/deck/messages.hpp"

namespace dda {

namespace {

using Arguments = std::vector<std::string>;

const Arguments& coordinates() {
  static const Arguments names{"x", "y"};
  return names;
}

const Arguments& time_alone() {
  static const Arguments names{"t"};
  return names;
}

bool speaks_of(const Node& node, const Arguments& arguments) {
  return node.is_scalar() && std::ranges::any_of(names_in(node.text), [&](const NameInText& found) {
           return std::ranges::find(arguments, found.name) != arguments.end();
         });
}

std::optional<Formula> read_formula(const Node& node, const Reading& reading, Dimension dimension,
                                    const Arguments& arguments) {
  if (!speaks_of(node, arguments)) {
    const auto value = number_kind(dimension).read(node, reading);
    return value ? std::optional<Formula>(*value) : std::nullopt;
  }
  Variables& variables = ReadingScope::variables();
  const auto compiled = variables.compile(node, arguments);
  if (const auto* failure = std::get_if<Variables::Failure>(&compiled)) {
    if (!failure->is_told)
      add_finding(failure->where, reading,
                  fmt::format("expected a number or an expression of {}, found {}: {}",
                              fmt::join(arguments, " and "), found(node), failure->what));
    return {};
  }
  return Formula(std::get<0>(compiled), variables.resolved(node, arguments), node.where);
}

Kind<Formula> kind_of(Dimension dimension, const Arguments& arguments) {
  auto read = [dimension, &arguments](const Node& node, const Reading& reading) {
    return read_formula(node, reading, dimension, arguments);
  };
  return {{.form = KindInfo::Form::number, .dimension = dimension}, read, [](const Formula& formula) {
            return formula.echo();
          }};
}

}  // namespace

double Formula::value(std::span<const double> arguments) const {
  if (!expression_) return value_;
  const double value = expression_->value(arguments);
  if (std::isfinite(value)) return value;
  throw InputError(where_, fmt::format("'{}' is no finite number at ({:.6g})", shortened(text_),
                                       fmt::join(arguments, ", ")));
}

bool Formula::is_plain() const {
  static constexpr std::string_view plain = "0123456789.+-*/^()xy ";
  if (text_.find_first_not_of(plain) != std::string::npos) return false;
  for (std::size_t at = text_.find('/'); at != std::string::npos; at = text_.find('/', at + 1))
    if (const std::size_t next = text_.find_first_not_of(' ', at + 1);
        next == std::string::npos || text_[next] < '0' || text_[next] > '9')
      return false;  // what divides by a place may be large next to one
  return true;
}

double Formula::operator()(const Vec2& x) const { return value(std::array{x.x(), x.y()}); }
double Formula::operator()(double time) const { return value(std::array{time}); }

Node Formula::echo() const {
  if (!expression_) return Node::number(value_);
  Node node = Node::scalar(text_);
  node.quoted = true;
  return node;
}

Kind<Formula> formula_kind(Dimension dimension) { return kind_of(dimension, coordinates()); }
Kind<Formula> time_formula_kind(Dimension dimension) { return kind_of(dimension, time_alone()); }

Kind<VectorFormula> vector_formula_kind(Dimension dimension) {
  auto read = [dimension](const Node& node, const Reading& reading) -> std::optional<VectorFormula> {
    if (!node.is_sequence() || node.items.size() != 2) {
      expected("two components [fx, fy]", node, reading);
      return {};
    }
    auto x = read_formula(node.items[0], reading, dimension, coordinates());
    auto y = read_formula(node.items[1], reading, dimension, coordinates());
    return x && y ? std::optional(VectorFormula{*x, *y}) : std::nullopt;
  };
  auto echo = [](const VectorFormula& v) { return Node::sequence({v.x.echo(), v.y.echo()}); };
  return {{.form = KindInfo::Form::point, .dimension = dimension}, read, echo};
}

}  // namespace dda
