#include "framework/deck/units.hpp"

#include <cstdlib>

namespace dda {

namespace {

std::string power(const std::string& unit, int exponent) {
  static const char* const superscripts[] = {"", "", "²", "³", "⁴"};
  if (exponent == 0) return "";
  return unit + (exponent < 5 ? superscripts[exponent] : "^" + std::to_string(exponent));
}

std::string product(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "·" + b;
}

std::string special_stress(const Units& units) {
  if (units.length == "mm") return units.force == "N" ? "MPa" : units.force == "kN" ? "GPa" : "";
  if (units.length != "m") return "";
  if (units.force == "N") return "Pa";
  if (units.force == "kN") return "kPa";
  return units.force == "MN" ? "MPa" : "";
}

}  // namespace

std::string label(Dimension dimension, const Units& units) {
  if (dimension == dimension::none) return "-";
  if (dimension == dimension::stress && !special_stress(units).empty()) return special_stress(units);
  const auto positive = [](int exponent) { return exponent > 0 ? exponent : 0; };
  const std::string over =
      product(power(units.force, positive(dimension.force)), power(units.length, positive(dimension.length)));
  const std::string under = product(power(units.force, positive(-dimension.force)),
                                    power(units.length, positive(-dimension.length)));
  return under.empty() ? over : (over.empty() ? "1" : over) + "/" + under;
}

std::string label(Dimension dimension) { return label(dimension, Units{"L", "F"}); }

}  // namespace dda
