// Kinds of numbers, and of what is made of them: a number may be an expression.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "framework/deck/expression/reading_scope.hpp"
#include "framework/deck/expression/variables.hpp"
#include "framework/deck/messages.hpp"

namespace dda {

namespace {

/// Products and quotients of a few numbers of a deck stay finite.
constexpr double largest_number = 1e50, smallest_number = 1e-50;

/// Plain scalars alone are numbers; a leading '+' is YAML's, not from_chars'.
template <class V>
std::from_chars_result parse(const Node& node, V& value) {
  const std::string& text = node.text;
  if (!node.is_scalar() || node.quoted) return {text.data(), std::errc::invalid_argument};
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return std::from_chars(text.data() + (has_plus ? 1 : 0), text.data() + text.size(), value);
}

bool is_whole(const std::from_chars_result& result, const Node& node) {
  return result.ec == std::errc() && result.ptr == node.text.data() + node.text.size();
}

bool is_plain_number(const Node& node) {
  double value = 0;
  return is_whole(parse(node, value), node);
}

bool is_not_finite(const Node& node) {
  std::string text = node.text;
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string bare = text.substr(std::min(text.find_first_not_of("+-."), text.size()));
  return node.is_scalar() && !node.quoted && (bare == "inf" || bare == "nan" || bare == "infinity");
}

/// "3 MPa": a number, a blank and a letter.
bool has_unit(const Node& node) {
  double value = 0;
  const auto result = parse(node, value);
  const char* end = node.text.data() + node.text.size();
  return result.ec == std::errc() && end - result.ptr > 1 && *result.ptr == ' ' &&
         std::isalpha(static_cast<unsigned char>(result.ptr[1])) != 0;
}

/// "3" or "-D/2, which is -50".
std::string shown(double value, const Node& node) {
  const std::string text = shortened(node.text);
  return is_plain_number(node) ? text : fmt::format("{}, which is {:.6g}", text, value);
}

bool check_magnitude(double value, const Node& node, const Reading& reading) {
  const double size = std::abs(value);
  if (size == 0 || (size >= smallest_number && size <= largest_number)) return true;
  add_finding(
      node.where, reading,
      shown(value, node) +
          (size > 1 ? " is larger than any quantity (1e50)" : " is smaller than any quantity (1e-50)") +
          "; choose other units");
  return false;
}

bool check_bounds(double value, const Bounds& bounds, const Node& node, const Reading& reading) {
  if (bounds.contains(value)) return true;
  add_finding(node.where, reading, "must be " + bounds.words() + ", got " + shown(value, node));
  return false;
}

void refuse(const Variables::Failure& failure, const char* wanted, const Node& node, const Reading& reading) {
  if (failure.is_told) return;
  const std::string what = fmt::format("expected {}, found {}", wanted, found(node));
  const bool is_word = is_name(node.text) && !ReadingScope::variables().has_any();
  if (has_unit(node))
    add_finding(node.where, reading, what + " (numbers carry no unit, the deck declares them)");
  else if (is_word)
    add_finding(node.where, reading, what);
  else
    add_finding(failure.where, reading, what + ": " + failure.what);
}

/// The value of an expression.
std::optional<double> evaluated(const Node& node, const char* wanted, const Reading& reading) {
  const auto compiled = ReadingScope::variables().compile(node);
  if (const auto* failure = std::get_if<Variables::Failure>(&compiled)) {
    refuse(*failure, wanted, node, reading);
    return {};
  }
  const double value = std::get<0>(compiled)->value({});
  if (std::isfinite(value))
    return check_magnitude(value, node, reading) ? std::optional(value) : std::nullopt;
  add_finding(node.where, reading, "must be a finite number, " + shown(value, node));
  return {};
}

std::optional<double> read_number(const Node& node, const Reading& reading) {
  double value = 0;
  const auto result = parse(node, value);
  if (is_not_finite(node))
    add_finding(node.where, reading, "must be a finite number, got " + node.text);
  else if (result.ec == std::errc::result_out_of_range)
    add_finding(node.where, reading, "'" + shortened(node.text) + "' is too large or too small for a number");
  else if (is_whole(result, node))
    return check_magnitude(value, node, reading) ? std::optional(value) : std::nullopt;
  else if (node.is_scalar())
    return evaluated(node, "a number", reading);
  else
    expected("a number", node, reading);
  return {};
}

/// An integer, but for the round-off of an expression.
std::optional<std::int64_t> whole(double value, const Node& node, const Reading& reading) {
  constexpr double round_off = 1e-9, largest = 9e15;
  const double nearest = std::round(value);
  if (std::abs(nearest) > largest)
    too_large(node, reading);
  else if (std::abs(value - nearest) > round_off * std::max(1.0, std::abs(value)))
    add_finding(node.where, reading, "expected an integer, found " + shown(value, node));
  else
    return static_cast<std::int64_t>(nearest);
  return {};
}

std::optional<std::int64_t> read_integer(const Node& node, const Reading& reading) {
  std::int64_t value = 0;
  const auto result = parse(node, value);
  if (result.ec == std::errc::result_out_of_range)
    too_large(node, reading);
  else if (is_whole(result, node))
    return value;
  else if (!node.is_scalar() || is_plain_number(node))
    expected("an integer", node, reading);
  else if (const auto number = evaluated(node, "an integer", reading))
    return whole(*number, node, reading);
  return {};
}

}  // namespace

Kind<double> number_kind(Dimension dimension, Bounds bounds) {
  auto read = [bounds](const Node& node, const Reading& reading) -> std::optional<double> {
    auto value = read_number(node, reading);
    return value && check_bounds(*value, bounds, node, reading) ? value : std::nullopt;
  };
  return {{.form = KindInfo::Form::number, .dimension = dimension, .bounds = bounds}, read, &Node::number};
}

Kind<std::int64_t> integer_kind(Bounds bounds) {
  auto read = [bounds](const Node& node, const Reading& reading) -> std::optional<std::int64_t> {
    auto value = read_integer(node, reading);
    const bool is_right = value && check_bounds(static_cast<double>(*value), bounds, node, reading);
    return is_right ? value : std::nullopt;
  };
  return {{.form = KindInfo::Form::integer, .bounds = bounds}, read, &Node::integer};
}

Kind<Vec2> point_kind(Dimension dimension) {
  auto read = [](const Node& node, const Reading& reading) -> std::optional<Vec2> {
    if (!node.is_sequence() || node.items.size() != 2) {
      expected("a point [x, y]", node, reading);
      return {};
    }
    const auto x = read_number(node.items[0], reading);
    const auto y = read_number(node.items[1], reading);
    return x && y ? std::optional<Vec2>(Vec2(*x, *y)) : std::nullopt;
  };
  auto echo = [](const Vec2& p) { return Node::sequence({Node::number(p.x()), Node::number(p.y())}); };
  return {{.form = KindInfo::Form::point, .dimension = dimension}, read, echo};
}

Kind<Spot> spot_kind() {
  const auto point = point_kind(dimension::length);
  auto read = [point](const Node& node, const Reading& reading) -> std::optional<Spot> {
    Spot out;
    out.where = node.where;
    if (node.is_scalar() && !node.text.empty() && !is_plain_number(node)) {
      out.name = node.text;
      return out;
    }
    if (!node.is_sequence() || node.items.size() != 2) {
      expected("a point [x, y] or the name of one of the scene's points", node, reading);
      return {};
    }
    const auto x = point.read(node, reading);
    if (!x) return {};
    out.x = *x;
    return out;
  };
  auto echo = [point](const Spot& spot) {
    return spot.name.empty() ? point.echo(spot.x) : echo_text(spot.name);
  };
  return {{.form = KindInfo::Form::spot, .dimension = dimension::length}, read, echo};
}

Kind<std::map<std::string, double>> variables_kind() {
  using Values = std::map<std::string, double>;
  auto read = [](const Node&, const Reading&) {
    return std::optional<Values>(ReadingScope::variables().values());
  };
  auto echo = [](const Values& values) {
    Node node = Node::map();
    for (const auto& [name, value] : values) node.set(name, Node::number(value));
    return node;
  };
  const KindInfo item{.form = KindInfo::Form::number};
  return {{.form = KindInfo::Form::map, .item = std::make_shared<KindInfo>(item)}, read, echo};
}

}  // namespace dda
