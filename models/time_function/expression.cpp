#include <cmath>

#include "framework/deck/formula.hpp"
#include "models/time_function/time_function.hpp"

namespace dda {
namespace {

struct ExpressionParameters {
  Formula value;
  Position where;
};

/// u = f(t), f(0) = 0.
class OfExpression final : public TimeFunction {
 public:
  explicit OfExpression(ExpressionParameters p) : p_(std::move(p)) {
    constexpr double hardly = 1e-12;
    if (std::abs(p_.value(0.0)) > hardly)
      throw InputError(p_.where, "value: is 0 at the time 0, the place where the motion begins");
  }
  double at(double time) const override { return p_.value(time); }

 private:
  ExpressionParameters p_;
};

Schema<ExpressionParameters> schema() {
  using P = ExpressionParameters;
  return Schema<P>("An expression of the time t.")
      .value(
          "value", &P::value, time_formula_kind(dimension::length),
          {.text = "Displacement as an expression of t [s], 0 at t = 0: \"A*sin(2*pi*f*t)*min(1, t/2)\"."});
}

}  // namespace

DDA_REGISTER(time_functions(), "expression", schema(), make_of<OfExpression>);

}  // namespace dda
