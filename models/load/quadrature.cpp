#include "models/load/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dda {
namespace {

using Function = std::function<Integrals(double)>;

/// Gauss-Lobatto's rule with five points on an interval: what changes next to an end is seen at the end.
Integrals lobatto(double a, double b, const Function& f) {
  static const double inner = std::sqrt(3.0 / 7);
  const double middle = (a + b) / 2, half = (b - a) / 2;
  const Integrals ends = f(a) + f(b), between = f(middle - inner * half) + f(middle + inner * half);
  return half * (ends / 10 + 49.0 / 90 * between + 32.0 / 45 * f(middle));
}

class Halving {
 public:
  Halving(const Function& f, double tolerance, int least) : f_(f), tolerance_(tolerance), least_(least) {}

  Integrals of(double a, double b, const Integrals& whole, int depth) {
    const double middle = (a + b) / 2;
    const Integrals left = lobatto(a, middle, f_), right = lobatto(middle, b, f_);
    const bool agree = depth >= least_ && (whole - left - right).cwiseAbs().maxCoeff() <= tolerance_;
    if (depth == deepest || ++halvings_ > most_halvings || agree) return left + right;
    return of(a, middle, left, depth + 1) + of(middle, b, right, depth + 1);
  }

 private:
  static constexpr int deepest = 40, most_halvings = 2000;
  const Function& f_;
  double tolerance_;
  int least_, halvings_ = 0;
};

/// Magnitude of what is integrated: sums of positive and negative parts may vanish.
double magnitude(double a, double b, const Function& f) {
  return lobatto(a, b, [&](double t) -> Integrals { return f(t).cwiseAbs(); }).cwiseAbs().maxCoeff();
}

/// Where a vertical line meets a side.
double height_of(const std::pair<Vec2, Vec2>& side, double x) {
  const auto& [from, to] = side;
  return from.y() + (x - from.x()) / (to.x() - from.x()) * (to.y() - from.y());
}

/// Sides that cross the strip from a to b, from the lowest to the highest.
std::vector<std::pair<Vec2, Vec2>> sides_across(const Polygon& polygon, double a, double b) {
  const double middle = (a + b) / 2;
  std::vector<std::pair<Vec2, Vec2>> out;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if ((polygon.at(i).x() < middle) != (polygon.at(i + 1).x() < middle))
      out.emplace_back(polygon.at(i), polygon.at(i + 1));
  std::ranges::sort(out, {}, [middle](const auto& side) { return height_of(side, middle); });
  return out;
}

}  // namespace

Integrals integral(double a, double b, const Function& f, int least_halvings) {
  constexpr double precision = 1e-11;
  return Halving(f, precision * magnitude(a, b, f), least_halvings).of(a, b, lobatto(a, b, f), 0);
}

Integrals integral(const Polygon& polygon, const std::function<Integrals(const Vec2&)>& f) {
  std::vector<double> abscissae;
  for (const Vec2& vertex : polygon.vertices) abscissae.push_back(vertex.x());
  std::ranges::sort(abscissae);
  Integrals sum = Integrals::Zero();
  for (std::size_t i = 0; i + 1 < abscissae.size(); ++i) {
    const double a = abscissae[i], b = abscissae[i + 1];
    if (a == b) continue;
    const auto sides = sides_across(polygon, a, b);
    for (std::size_t s = 0; s + 1 < sides.size(); s += 2)
      sum += integral(a, b, [&](double x) {
        return integral(height_of(sides[s], x), height_of(sides[s + 1], x),
                        [&](double y) { return f(Vec2(x, y)); });
      });
  }
  return sum;
}

}  // namespace dda
