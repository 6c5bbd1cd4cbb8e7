#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "framework/base/vec2.hpp"
#include "framework/deck/bounds.hpp"
#include "framework/deck/document/node.hpp"
#include "framework/deck/document/spot.hpp"
#include "framework/deck/units.hpp"

namespace dda {

class SchemaBase;
class FamilyBase;

/// What a reader carries along: where findings go, the deck's folder, and how to name the place in a message.
struct Reading {
  Findings& findings;
  std::filesystem::path folder;  ///< relative file names start here
  std::string name;              ///< of the parameter being read: "law", "loads.1"
  std::string context;           ///< of the struct being read: "interface 'joint'"

  Reading at(std::string new_name) const { return {findings, folder, std::move(new_name), context}; }
  Reading in(std::string new_context) const { return {findings, folder, name, std::move(new_context)}; }
};

/// All that can be said of a kind of value without its C++ type; explain and the JSON schema are written from
/// it.
struct KindInfo {
  enum class Form {
    number,
    integer,
    boolean,
    text,
    name,
    file,
    point,
    spot,
    section,
    family,
    list,
    map,
    anything
  };

  Form form = Form::anything;
  Dimension dimension{};
  Bounds bounds{};
  std::vector<std::string> names{};  ///< of a name: what may be chosen; of a list: words in its place
  std::shared_ptr<const SchemaBase> section{};  ///< of a section
  const FamilyBase* family = nullptr;           ///< of a member of a family
  std::shared_ptr<const KindInfo> item{};       ///< of a list or map
  std::size_t at_least = 0;                     ///< of a list or map: the fewest entries

  /// "number", "list of points", "one of plane_stress, plane_strain".
  std::string words() const;
};

/// How values of one type are read from a node and written back.
///
///     read(node, reading) → the value, or nothing after adding what is wrong to the findings
///     echo(value)         → a node that reads back to the same value
template <class V>
struct Kind {
  KindInfo info;
  std::function<std::optional<V>(const Node&, const Reading&)> read;
  std::function<Node(const V&)> echo;

  Kind() = default;
  Kind(KindInfo i, decltype(read) r, decltype(echo) e)
      : info(std::move(i)), read(std::move(r)), echo(std::move(e)) {}
  /// A Schema<V> is the kind of a section, a Family that of a choice.
  template <class Source>
  requires requires(const Source& s) {
    { s.kind() } -> std::same_as<Kind<V>>;
  }
  Kind(const Source& source) : Kind(source.kind()) {}
};

Kind<double> number_kind(Dimension dimension = {}, Bounds bounds = {});  ///< finite; 1 is accepted for 1.0
Kind<std::int64_t> integer_kind(Bounds bounds = {});
Kind<bool> boolean_kind();
Kind<std::string> text_kind();
Kind<std::filesystem::path> file_kind(bool must_exist = true);
Kind<Vec2> point_kind(Dimension dimension = dimension::length);  ///< [x, y]
Kind<Spot> spot_kind();                                          ///< [x, y] or the name of a point
Kind<Node> anything_kind();

/// The position in `names` of a name that may be chosen.
std::optional<std::size_t> read_name(const Node& node, const std::vector<std::string>& names,
                                     const Reading& reading);
/// Whether a node is a list (a map) of enough entries; adds a finding if not.
bool is_list(const Node& node, std::size_t at_least, const Reading& reading);
bool is_map_of(const Node& node, std::size_t at_least, const Reading& reading);
/// Adds "name: expected a number, found the text 'x'".
void expected(const std::string& what, const Node& node, const Reading& reading);
/// Adds "name: 300 is too large" for an integer that V cannot hold.
void too_large(const Node& node, const Reading& reading);
/// Messages name an entry of `interfaces` as "interface 'joint'".
std::string entry_context(const std::string& parameter, const std::string& key);

/// Integers of any C++ type; what does not fit the type is a finding.
template <std::integral V>
Kind<V> integer_of(Bounds bounds) {
  auto wide = integer_kind(bounds);
  auto read = [wide](const Node& node, const Reading& reading) -> std::optional<V> {
    auto value = wide.read(node, reading);
    if (!value) return {};
    if (std::in_range<V>(*value)) return static_cast<V>(*value);
    too_large(node, reading);
    return {};
  };
  return {wide.info, read, [](const V& value) { return Node::integer(static_cast<std::int64_t>(value)); }};
}

template <class V>
using Names = std::vector<std::pair<std::string, V>>;

/// Named values of an enumeration.
template <class V>
Kind<V> name_of(Names<V> values) {
  KindInfo info{.form = KindInfo::Form::name};
  for (const auto& [name, value] : values) info.names.push_back(name);
  auto read = [values, names = info.names](const Node& node, const Reading& reading) -> std::optional<V> {
    auto index = read_name(node, names, reading);
    return index ? std::optional<V>(values[*index].second) : std::nullopt;
  };
  auto echo = [values](const V& value) {
    for (const auto& [name, known] : values)
      if (known == value) return Node::scalar(name);
    return Node{};
  };
  return {std::move(info), read, echo};
}

/// A list of values of one kind.
template <class V>
Kind<std::vector<V>> list_of(Kind<V> item, std::size_t at_least = 0) {
  KindInfo info{
      .form = KindInfo::Form::list, .item = std::make_shared<KindInfo>(item.info), .at_least = at_least};
  auto read = [item, at_least](const Node& node, const Reading& reading) -> std::optional<std::vector<V>> {
    if (!is_list(node, at_least, reading)) return {};
    std::vector<V> values;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const std::string name = reading.name + "." + std::to_string(i);
      if (auto value = item.read(node.items[i], reading.at(name).in(name)))
        values.push_back(std::move(*value));
    }
    return values.size() == node.items.size() ? std::optional(std::move(values)) : std::nullopt;
  };
  auto echo = [item](const std::vector<V>& values) {
    Node node = Node::sequence();
    for (const V& value : values) node.items.push_back(item.echo(value));
    return node;
  };
  return {std::move(info), read, echo};
}

/// The same of at least one value, or a word in its place, which is read as an empty list.
template <class V>
Kind<std::vector<V>> list_or_word(Kind<V> item, const std::string& word) {
  const Kind<std::vector<V>> list = list_of(std::move(item), 1);
  KindInfo info = list.info;
  info.names = {word};
  auto read = [list, names = info.names](const Node& node,
                                         const Reading& reading) -> std::optional<std::vector<V>> {
    if (!node.is_scalar()) return list.read(node, reading);
    return read_name(node, names, reading) ? std::optional(std::vector<V>()) : std::nullopt;
  };
  auto echo = [list, word](const std::vector<V>& values) {
    return values.empty() ? Node::scalar(word) : list.echo(values);
  };
  return {std::move(info), read, echo};
}

/// A map from free names to values of one kind; M is std::map<std::string, V> or a vector of pairs, which
/// keeps order.
template <class M, class V = typename M::value_type::second_type>
Kind<M> map_of(Kind<V> item, std::size_t at_least = 0) {
  KindInfo info{
      .form = KindInfo::Form::map, .item = std::make_shared<KindInfo>(item.info), .at_least = at_least};
  auto read = [item, at_least](const Node& node, const Reading& reading) -> std::optional<M> {
    if (!is_map_of(node, at_least, reading)) return {};
    M values;
    for (const auto& [key, where, child] : node.entries)
      if (auto value =
              item.read(child, reading.at(reading.name + "." + key).in(entry_context(reading.name, key))))
        values.insert(values.end(), typename M::value_type(key, std::move(*value)));
    return values.size() == node.entries.size() ? std::optional(std::move(values)) : std::nullopt;
  };
  auto echo = [item](const M& values) {
    Node node = Node::map();
    for (const auto& [key, value] : values) node.set(key, item.echo(value));
    return node;
  };
  return {std::move(info), read, echo};
}

}  // namespace dda
