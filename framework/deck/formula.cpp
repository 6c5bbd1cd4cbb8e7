#include "framework/deck/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/deck/expression/reading_scope.hpp"
#include "framework/deck/messages.hpp"

namespace dda {

namespace {

const std::vector<std::string>& coordinates() {
  static const std::vector<std::string> names{"x", "y"};
  return names;
}

bool speaks_of_place(const Node& node) {
  return node.is_scalar() && std::ranges::any_of(names_in(node.text), [](const NameInText& found) {
           return std::ranges::find(coordinates(), found.name) != coordinates().end();
         });
}

std::optional<Formula> read_formula(const Node& node, const Reading& reading, Dimension dimension) {
  if (!speaks_of_place(node)) {
    const auto value = number_kind(dimension).read(node, reading);
    return value ? std::optional<Formula>(*value) : std::nullopt;
  }
  Variables& variables = ReadingScope::variables();
  const auto compiled = variables.compile(node, coordinates());
  if (const auto* failure = std::get_if<Variables::Failure>(&compiled)) {
    if (!failure->is_told)
      add_finding(failure->where, reading,
                  fmt::format("expected a number or an expression of x and y, found {}: {}", found(node),
                              failure->what));
    return {};
  }
  return Formula(std::get<0>(compiled), variables.resolved(node, coordinates()), node.where);
}

}  // namespace

double Formula::operator()(const Vec2& x) const {
  if (!expression_) return value_;
  const double value = expression_->value(std::array{x.x(), x.y()});
  if (std::isfinite(value)) return value;
  throw InputError(
      where_, fmt::format("'{}' is no finite number at ({:.6g}, {:.6g})", shortened(text_), x.x(), x.y()));
}

Node Formula::echo() const {
  if (!expression_) return Node::number(value_);
  Node node = Node::scalar(text_);
  node.quoted = true;
  return node;
}

Kind<Formula> formula_kind(Dimension dimension) {
  auto read = [dimension](const Node& node, const Reading& reading) {
    return read_formula(node, reading, dimension);
  };
  return {{.form = KindInfo::Form::number, .dimension = dimension}, read, [](const Formula& formula) {
            return formula.echo();
          }};
}

Kind<VectorFormula> vector_formula_kind(Dimension dimension) {
  auto read = [dimension](const Node& node, const Reading& reading) -> std::optional<VectorFormula> {
    if (!node.is_sequence() || node.items.size() != 2) {
      expected("two components [fx, fy]", node, reading);
      return {};
    }
    auto x = read_formula(node.items[0], reading, dimension);
    auto y = read_formula(node.items[1], reading, dimension);
    return x && y ? std::optional(VectorFormula{*x, *y}) : std::nullopt;
  };
  auto echo = [](const VectorFormula& v) { return Node::sequence({v.x.echo(), v.y.echo()}); };
  return {{.form = KindInfo::Form::point, .dimension = dimension}, read, echo};
}

}  // namespace dda
