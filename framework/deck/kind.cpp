#include "framework/deck/kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "framework/base/suggestion.hpp"
#include "framework/deck/family.hpp"

namespace dda {

namespace {

/// Products and quotients of a few numbers of a deck stay finite.
constexpr double largest_number = 1e50, smallest_number = 1e-50;

std::string shortened(const std::string& text) {
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

std::string found(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::sequence:
      return "a list";
    case Node::Kind::map:
      return "a map";
    default:
      return (node.quoted ? "the text '" : "'") + shortened(node.text) + "'";
  }
}

void add(const Node& node, const Reading& reading, const std::string& what) {
  reading.findings.add(node.where, reading.name.empty() ? what : reading.name + ": " + what);
}

bool check_magnitude(double value, const Node& node, const Reading& reading) {
  const double size = std::abs(value);
  if (size == 0 || (size >= smallest_number && size <= largest_number)) return true;
  add(node, reading,
      shortened(node.text) +
          (size > 1 ? " is larger than any quantity (1e50)" : " is smaller than any quantity (1e-50)") +
          "; choose other units");
  return false;
}

bool check_bounds(double value, const Bounds& bounds, const Node& node, const Reading& reading) {
  if (bounds.contains(value)) return true;
  add(node, reading, "must be " + bounds.words() + ", got " + shortened(node.text));
  return false;
}

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

std::optional<double> read_number(const Node& node, const Reading& reading) {
  double value = 0;
  const auto result = parse(node, value);
  if (is_not_finite(node))
    add(node, reading, "must be a finite number, got " + node.text);
  else if (result.ec == std::errc::result_out_of_range)
    add(node, reading, "'" + shortened(node.text) + "' is too large or too small for a number");
  else if (is_whole(result, node))
    return check_magnitude(value, node, reading) ? std::optional(value) : std::nullopt;
  else if (result.ec == std::errc() && node.text[result.ptr - node.text.data()] == ' ')
    add(node, reading,
        "expected a number, found " + found(node) + " (numbers carry no unit, the deck declares them)");
  else
    expected("a number", node, reading);
  return {};
}

std::optional<std::string> read_text(const Node& node, const Reading& reading) {
  if (node.is_scalar()) return node.text;
  expected("a text", node, reading);
  return {};
}

/// Quoted where another YAML reader would see a number or a truth value.
Node echo_text(const std::string& text) {
  Node node = Node::scalar(text);
  const bool is_word = std::any_of(text.begin(), text.begin() + (text.empty() ? 0 : 1),
                                   [](unsigned char c) { return std::isalpha(c) || c == '/'; });
  const std::string reserved[] = {"true", "false", "yes", "no", "on", "off", "y", "n"};
  node.quoted = !is_word || std::count(std::begin(reserved), std::end(reserved), text) > 0;
  return node;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string entries(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

bool has_enough(std::size_t count, std::size_t at_least, const Node& node, const Reading& reading) {
  if (count >= at_least) return true;
  add(node, reading, "must have at least " + entries(at_least) + ", got " + std::to_string(count));
  return false;
}

}  // namespace

std::string KindInfo::words() const {
  switch (form) {
    case Form::number:
      return "number";
    case Form::integer:
      return "integer";
    case Form::boolean:
      return "true or false";
    case Form::text:
      return "text";
    case Form::name:
      return "one of " + joined(names);
    case Form::file:
      return "file";
    case Form::point:
      return "point [x, y]";
    case Form::spot:
      return "point [x, y], or the name of one";
    case Form::section:
      return "section";
    case Form::family:
      return "a " + family->name();
    case Form::list:
      return (names.empty() ? "" : fmt::format("`{}`, or ", fmt::join(names, "`, `"))) +
             "list of: " + item->words();
    case Form::map:
      return "map from names to: " + item->words();
    case Form::anything:
      break;
  }
  return "anything";
}

void expected(const std::string& what, const Node& node, const Reading& reading) {
  add(node, reading, "expected " + what + ", found " + found(node));
}

void too_large(const Node& node, const Reading& reading) {
  add(node, reading, shortened(node.text) + " is out of range");
}

std::optional<std::size_t> read_name(const Node& node, const std::vector<std::string>& names,
                                     const Reading& reading) {
  if (!node.is_scalar()) {
    expected("a name", node, reading);
    return {};
  }
  const auto at = std::find(names.begin(), names.end(), node.text);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  add(node, reading, "unknown value '" + shortened(node.text) + "'" + suggest(node.text, names));
  return {};
}

bool is_list(const Node& node, std::size_t at_least, const Reading& reading) {
  if (node.is_sequence()) return has_enough(node.items.size(), at_least, node, reading);
  expected("a list", node, reading);
  return false;
}

bool is_map_of(const Node& node, std::size_t at_least, const Reading& reading) {
  if (node.is_map()) return has_enough(node.entries.size(), at_least, node, reading);
  expected("a map from names to values", node, reading);
  return false;
}

std::string entry_context(const std::string& parameter, const std::string& key) {
  std::string one = parameter.substr(parameter.rfind('.') + 1);
  if (one.ends_with("ies"))
    one.replace(one.size() - 3, 3, "y");
  else if (one.ends_with("s"))
    one.pop_back();
  return one + " '" + key + "'";
}

Kind<double> number_kind(Dimension dimension, Bounds bounds) {
  auto read = [bounds](const Node& node, const Reading& reading) -> std::optional<double> {
    auto value = read_number(node, reading);
    return value && check_bounds(*value, bounds, node, reading) ? value : std::nullopt;
  };
  return {{.form = KindInfo::Form::number, .dimension = dimension, .bounds = bounds}, read, &Node::number};
}

Kind<std::int64_t> integer_kind(Bounds bounds) {
  auto read = [bounds](const Node& node, const Reading& reading) -> std::optional<std::int64_t> {
    std::int64_t value = 0;
    const auto result = parse(node, value);
    if (result.ec == std::errc::result_out_of_range)
      too_large(node, reading);
    else if (!is_whole(result, node))
      expected("an integer", node, reading);
    else if (check_bounds(static_cast<double>(value), bounds, node, reading))
      return value;
    return {};
  };
  return {{.form = KindInfo::Form::integer, .bounds = bounds}, read, &Node::integer};
}

Kind<bool> boolean_kind() {
  auto read = [](const Node& node, const Reading& reading) -> std::optional<bool> {
    if (node.is_scalar() && !node.quoted && (node.text == "true" || node.text == "false"))
      return node.text == "true";
    expected("true or false", node, reading);
    return {};
  };
  return {{.form = KindInfo::Form::boolean}, read, &Node::boolean};
}

Kind<std::string> text_kind() { return {{.form = KindInfo::Form::text}, read_text, echo_text}; }

Kind<std::filesystem::path> file_kind(bool must_exist) {
  auto read = [must_exist](const Node& node, const Reading& reading) -> std::optional<std::filesystem::path> {
    const auto text = read_text(node, reading);
    if (!text) return {};
    if (text->empty() || text->find('\0') != std::string::npos) {
      expected("a file name", node, reading);
      return {};
    }
    const auto path = std::filesystem::absolute(reading.folder / *text).lexically_normal();
    std::error_code error;
    if (!must_exist || std::filesystem::exists(path, error)) return path;
    add(node, reading, "no such file '" + *text + "' (looked for " + path.string() + ")");
    return {};
  };
  auto echo = [](const std::filesystem::path& path) { return echo_text(path.string()); };
  return {{.form = KindInfo::Form::file}, read, echo};
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

Kind<Node> anything_kind() {
  auto read = [](const Node& node, const Reading&) { return std::optional<Node>(node); };
  return {{.form = KindInfo::Form::anything}, read, [](const Node& node) { return node; }};
}

}  // namespace dda
