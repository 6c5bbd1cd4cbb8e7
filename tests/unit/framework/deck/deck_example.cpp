#include "unit/framework/deck/deck_example.hpp"

namespace dda::example {

namespace {

struct Bonded {};

Schema<Bonded> bonded_schema() { return Schema<Bonded>("Two sides that stay together."); }

std::unique_ptr<Law> make_bonded(const Bonded&, double) { return std::make_unique<Law>(Law{"bonded", 0}); }

struct Softening {
  double strength = 0, energy = 0;
  int exponent = 0;
  Position where;
};

Schema<Softening> softening_schema() {
  return Schema<Softening>("Softening to a stress-free crack.")
      .number("strength", &Softening::strength,
              {.dimension = dimension::stress, .bounds = above(0), .text = "Traction at the first crack."})
      .number(
          "energy", &Softening::energy,
          {.dimension = dimension::energy_per_area, .bounds = above(0), .text = "Work per area of crack."})
      .integer("exponent", &Softening::exponent,
               {.fallback = 1, .bounds = between(1, 9), .text = "Of the curve."})
      .check([](const Softening& p, const Position& where, Findings& findings) {
        if (p.energy > 100 * p.strength) findings.add(where, "energy: too large for the strength");
      });
}

std::unique_ptr<Law> make_softening(const Softening& p, double scale) {
  if (scale <= 0) throw InputError(p.where, "no room for the law");
  return std::make_unique<Law>(Law{"softening", p.strength * scale});
}

}  // namespace

DDA_REGISTER(laws(), "bonded", bonded_schema(), make_bonded)
DDA_REGISTER(laws(), "softening", softening_schema(), make_softening)

}  // namespace dda::example
