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

/// digit · 10^exponent, as long as that has few zeros in digits.
std::string decade_label(int digit, int exponent) {
  if (exponent < large_exponent && exponent > small_exponent)
    return label_of(digit * std::pow(10.0, exponent), std::max(0, -exponent));
  const std::string power = fmt::format("10{}", superscript(exponent));
  return digit == 1 ? power : fmt::format("{}·{}", digit, power);
}

/// The whole numbers in a range, from its first to its last.
struct Decades {
  int first, last;

  explicit Decades(const Range& range)
      : first(static_cast<int>(std::ceil(range.low - rounding))),
        last(static_cast<int>(std::floor(range.high + rounding))) {}
  int count() const { return last - first + 1; }
};

/// Ticks at digits of decades, where `label(digit, exponent)` gives what is written there.
template <class Label>
std::vector<Tick> ticks_of_digits(const Range& range, const Label& label) {
  std::vector<Tick> out;
  const Decades decades(range);
  for (int exponent = decades.first - 1; exponent <= decades.last; ++exponent)
    for (int digit = 1; digit < 10; ++digit) {
      const double value = exponent + std::log10(digit);
      if (value < range.low - rounding || value > range.high + rounding) continue;
      std::string text = label(digit, exponent);
      const bool is_minor = text.empty();
      out.push_back({value, std::move(text), is_minor});
    }
  return out;
}

/// Decades, each few of them with a label where they are many; digits between those that all have one.
std::vector<Tick> ticks_of_decades(const Range& range, int wanted) {
  const int stride = (Decades(range).count() + wanted - 1) / wanted;
  std::vector<Tick> out = ticks_of_digits(range, [&](int digit, int exponent) {
    return digit == 1 && exponent % stride == 0 ? decade_label(digit, exponent) : std::string();
  });
  const auto is_between = [](const Tick& tick) { return tick.value != std::round(tick.value); };
  if (stride > 1) std::erase_if(out, is_between);
  return out;
}

/// Of a range so short that logarithms are nearly even.
Axis nearly_even_axis(const Range& range, int wanted) {
  Axis out = make_axis({std::pow(10.0, range.low), std::pow(10.0, range.high), false}, wanted);
  out.range = range;
  for (Tick& tick : out.ticks) tick.value = std::log10(tick.value);
  return out;
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

Axis make_logarithmic_axis(const Range& range, int wanted) {
  if (Decades(range).count() > 1) return {range, ticks_of_decades(range, wanted), {}};
  std::vector<Tick> ticks = ticks_of_digits(range, [](int digit, int exponent) {
    const bool is_round = std::ranges::find(round_digits, digit) != round_digits.end();
    return is_round ? decade_label(digit, exponent) : std::string();
  });
  const auto with_labels = std::ranges::count(ticks, false, &Tick::is_minor);
  return with_labels > 1 ? Axis{range, std::move(ticks), {}} : nearly_even_axis(range, wanted);
}

}  // namespace dda::svg
