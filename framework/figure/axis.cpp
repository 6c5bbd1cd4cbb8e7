#include "framework/figure/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string_view>

#include "framework/figure/style.hpp"

namespace dda::svg {
namespace {

/// The round step closest from above to one that gives `wanted` intervals.
double round_step(double length, int wanted) {
  const double rough = length / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const int digit : round_digits)
    if (rough <= digit * power * (1 + rounding)) return digit * power;
  return 10 * power;
}

std::string superscript(int number) {
  static constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) text += digits[c - '0'];
  return text;
}

/// Power of ten of a positive number, safe against log10(1000) = 2.9999.
int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(value) + rounding)); }

/// Labels of at most about six characters need no power of ten.
int common_exponent(double largest) {
  const int exponent = exponent_of(largest);
  return exponent >= large_exponent || exponent <= small_exponent
             ? 3 * static_cast<int>(std::floor(exponent / 3.0))
             : 0;
}

std::string typographic(std::string text) {
  if (text.front() != '-') return text;
  if (text.find_first_of("123456789") == std::string::npos) return text.substr(1);
  return text.replace(0, 1, "−");
}

std::string label_of(double value, int decimals) {
  return typographic(fmt::format("{:.{}f}", value, decimals));
}

/// Where many digits would be the same in all labels, they are taken out.
double common_offset(const Range& range, double step) {
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  return largest / step > most_steps ? std::ceil(range.low / step) * step : 0.0;
}

std::string scale_of(double offset, int exponent) {
  std::string text = exponent == 0 ? "" : fmt::format("×10{}", superscript(exponent));
  if (offset == 0) return text;
  return fmt::format("{}{}{} {:.15g}", text, text.empty() ? "" : " ", offset < 0 ? "−" : "+",
                     std::abs(offset));
}

}  // namespace

void Range::include(double value) {
  if (!std::isfinite(value)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

Range Range::widened(double part) const {
  if (empty) return {0, 1, false};
  const double largest = std::max(std::abs(low), std::abs(high));
  const double length = high - low;
  // Differences of the size of the rounding are no differences.
  if (!(length > least_length * largest)) {
    const double around = largest > 0 ? half_of_no_length * largest : 1.0;
    return {low - around, high + around, false};
  }
  return {low - part * length, high + part * length, false};
}

double round_down(double value) {
  const double power = std::pow(10.0, exponent_of(value));
  for (const int digit : std::views::reverse(round_digits))
    if (digit * power <= value) return digit * power;
  return power;
}

Axis make_axis(const Range& range, int wanted) {
  const double step = round_step(range.high - range.low, wanted);
  const double offset = common_offset(range, step);
  const double largest = std::max(std::abs(range.low - offset), std::abs(range.high - offset));
  const int exponent = common_exponent(largest);
  const double unit = std::pow(10.0, exponent);
  const int decimals = std::max(0, -exponent_of(step / unit));
  Axis axis{range, {}, scale_of(offset, exponent)};
  const double slack = tick_slack * step;
  for (double n = std::ceil((range.low - slack) / step); n * step <= range.high + slack; ++n) {
    axis.ticks.push_back({n * step, label_of((n * step - offset) / unit, decimals)});
  }
  return axis;
}

}  // namespace dda::svg
