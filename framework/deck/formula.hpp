#pragma once

#include "framework/deck/expression/expression.hpp"
#include "framework/deck/kind.hpp"

namespace dda {

/// A quantity that depends on the place, f(x, y), or on time, f(t): a number, or an expression of x and y [L] or of t [s], and
/// of the deck's variables. Not for several threads at once.
class Formula {
 public:
  Formula(double value = 0) : value_(value) {}
  /// `text` says the same without variables.
  Formula(std::shared_ptr<const Expression> expression, std::string text, Position where)
      : expression_(std::move(expression)), text_(std::move(text)), where_(std::move(where)) {}

  bool is_constant() const { return !expression_; }
  /// Whether it is made of sums and products of numbers and places, in which nothing narrow hides.
  bool is_plain() const;
  /// Throws InputError with the place or the time where it is no finite number.
  double operator()(const Vec2& x) const;
  double operator()(double time) const;
  Node echo() const;

 private:
  double value(std::span<const double> arguments) const;

  double value_ = 0;  ///< of a constant
  std::shared_ptr<const Expression> expression_;
  std::string text_;
  Position where_;
};

/// Two of them, the components of a vector.
struct VectorFormula {
  Formula x, y;

  bool is_constant() const { return x.is_constant() && y.is_constant(); }
  bool is_plain() const { return x.is_plain() && y.is_plain(); }
  Vec2 operator()(const Vec2& place) const { return {x(place), y(place)}; }
};

Kind<Formula> formula_kind(Dimension dimension);               ///< of x and y
Kind<Formula> time_formula_kind(Dimension dimension);          ///< of t
Kind<VectorFormula> vector_formula_kind(Dimension dimension);  ///< [fx, fy]

}  // namespace dda
