#include "framework/deck/changes/range.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

namespace dda {
namespace {

/// The last value may miss the end by this part of a step: 0.1 has no exact binary form.
constexpr double step_slack = 1e-9;

constexpr const char* forms = "a range is 1..20, 0.1..1 step 0.1 or 0.05..10 log 8";

template <class T>
std::optional<T> read_as(const std::string& text) {
  T value{};
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(begin, end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

/// "FROM..TO" and, behind it, "step STEP" or "log COUNT".
struct Range {
  std::string from, to, word, number;
};

class RangeReader {
 public:
  RangeReader(const Node& node, std::size_t at_most) : node_(node), at_most_(at_most) {}

  std::vector<Node> read() {
    split();
    if (range_.word == "log") return logarithmic();
    const bool is_integer = read_as<std::int64_t>(range_.from) && read_as<std::int64_t>(range_.to) &&
                            (range_.word.empty() || read_as<std::int64_t>(range_.number));
    const double from = number(range_.from), to = number(range_.to);
    if (!is_integer && range_.word.empty() && from <= to)
      fail("a range of numbers that are no integers needs a step, as in 0.1..1 step 0.1");
    return linear(is_integer);
  }

 private:
  void split() {
    const auto dots = node_.text.find("..");
    std::istringstream rest(node_.text.substr(dots + 2));
    std::istringstream(node_.text.substr(0, dots)) >> range_.from;
    std::string more;
    rest >> range_.to >> range_.word >> range_.number >> more;
    const bool has_count = range_.word == "step" || range_.word == "log";
    if (!more.empty() || (!range_.word.empty() && !has_count) || (has_count && range_.number.empty()))
      fail(forms);
  }

  std::vector<Node> linear(bool is_integer) const {
    const double from = number(range_.from), to = ending(from);
    const double step = range_.word.empty() ? 1 : number(range_.number);
    if (step <= 0) fail("the step must be above 0");
    const double steps = std::floor((to - from) / step + step_slack);
    check_count(steps + 1);
    std::vector<Node> values;
    for (double i = 0; i <= steps; ++i) values.push_back(value(from + i * step, is_integer));
    return values;
  }

  std::vector<Node> logarithmic() const {
    const double from = number(range_.from), to = ending(from);
    const auto count = read_as<std::int64_t>(range_.number);
    if (from <= 0) fail("a logarithmic range begins above 0");
    if (!count || *count < 2) fail("expected the number of values, 2 or more, behind 'log'");
    check_count(static_cast<double>(*count));
    std::vector<Node> values;
    for (std::int64_t i = 0; i < *count; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(*count - 1);
      values.push_back(value(from * std::pow(to / from, part), false));
    }
    return values;
  }

  double number(const std::string& text) const {
    const auto value = read_as<double>(text);
    if (!value || !std::isfinite(*value)) fail(fmt::format("'{}' is not a number; {}", text, forms));
    return *value;
  }

  double ending(double from) const {
    const double to = number(range_.to);
    if (to < from) fail("the range ends before it begins");
    return to;
  }

  void check_count(double count) const {
    if (count > static_cast<double>(at_most_)) fail(fmt::format("more than {} values", at_most_));
  }

  Node value(double number, bool is_integer) const {
    Node out = is_integer ? Node::integer(std::llround(number))
                          : Node::number(std::stod(fmt::format("{:.12g}", number)));
    out.where = node_.where;
    return out;
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(node_.where, fmt::format("range '{}': {}", node_.text, why));
  }

  const Node& node_;
  const std::size_t at_most_;
  Range range_;
};

}  // namespace

bool is_range(const Node& node) { return node.is_scalar() && node.text.find("..") != std::string::npos; }

std::vector<Node> read_range(const Node& node, std::size_t at_most) {
  return RangeReader(node, at_most).read();
}

}  // namespace dda
