#pragma once

#include <nlohmann/json_fwd.hpp>

#include "framework/deck/kind.hpp"

namespace dda {

/// JSON that keeps the order in which it was written.
using Json = nlohmann::ordered_json;

/// One parameter as the user sees it: what `dda explain` prints and what every registered thing must supply.
struct Parameter {
  std::string name;
  std::string text;
  KindInfo kind;
  std::optional<Node> fallback;  ///< the value when the deck has none
  bool may_be_absent = false;    ///< no value is a value: a std::optional member

  bool is_required() const { return !fallback && !may_be_absent; }
};

/// A declared struct without its C++ type; Schema<T> is the public face.
class SchemaBase {
 public:
  explicit SchemaBase(std::string text) : text_(std::move(text)) {}
  virtual ~SchemaBase() = default;

  /// One sentence about the struct.
  const std::string& text() const { return text_; }
  std::vector<Parameter> parameters() const;
  /// Whether a deck must give something here; a section that need not may be left out.
  bool has_required() const;
  /// Draft-07 JSON schema of the struct, families under "definitions".
  Json json_schema() const;

  /// Fills the struct at `target`; false when something was wrong, after adding it to the findings.
  bool read_into(void* target, const Node& node, const Reading& reading) const;
  /// Every parameter of the struct at `source` with its value.
  Node echo_from(const void* source) const;

 protected:
  struct Field {
    Parameter parameter;
    std::function<bool(void*, const Node&, const Reading&)> read;
    std::function<std::optional<Node>(const void*)> echo;
  };
  std::string text_;
  std::vector<Field> fields_;
  std::function<void(void*, const Position&)> set_where_;  ///< empty when the struct has no Position
  std::vector<std::function<void(const void*, const Position&, Findings&)>> checks_;

  void declare(Field field);

 private:
  bool read_field(const Field& field, void* target, const Node& node, const Reading& reading) const;
  bool reject_unknown(const Node& node, const Reading& reading) const;
  bool run_checks(const void* target, const Position& where, Findings& findings) const;
};

struct NumberOptions {
  std::optional<double> fallback{};  ///< none = the deck must give it
  Dimension dimension{};
  Bounds bounds{};
  std::string text{};
};

struct IntegerOptions {
  std::optional<std::int64_t> fallback{};
  Bounds bounds{};
  std::string text{};
};

template <class V>
struct ValueOptions {
  std::optional<V> fallback{};
  std::string text{};
};

struct FileOptions {
  std::optional<std::string> fallback{};
  bool must_exist = true;
  std::string text{};
};

struct PointOptions {
  std::optional<Vec2> fallback{};
  Dimension dimension = dimension::length;
  std::string text{};
};

/// Of lists and maps: without fallback they may be left out when they may be empty.
template <class V>
struct ManyOptions {
  std::optional<V> fallback{};
  Dimension dimension{};     ///< of numbers and points
  Bounds bounds{};           ///< of numbers
  std::size_t at_least = 0;  ///< the fewest entries
  std::string text{};
};

struct SectionOptions {
  std::string text{};  ///< the schema's own text when empty
};

namespace detail {
template <class M>
struct Unwrap {
  using type = M;
  static constexpr bool is_optional = false;
};
template <class V>
struct Unwrap<std::optional<V>> {
  using type = V;
  static constexpr bool is_optional = true;
};
/// What a member holds: V for V and for std::optional<V>.
template <class M>
using ValueOf = typename Unwrap<M>::type;

template <class T>
concept HasWhere = requires(T& value, const Position& where) {
  value.where = where;
};

template <class V>
std::optional<Node> fallback_node(const Kind<V>& kind, const std::optional<V>& fallback) {
  return fallback ? std::optional<Node>(kind.echo(*fallback)) : std::nullopt;
}
}  // namespace detail

/// The parameters of a plain struct, each declared once by binding a name to a member.
///
///     Schema<P>("One sentence about P.")
///         .number("tensile_strength", &P::tensile_strength,
///                 {.dimension = dimension::stress, .bounds = above(0), .text = "..."})
///         .number("shear_weight", &P::shear_weight, {.fallback = 1.0, .bounds = above(0), .text = "..."})
///
/// A member std::optional<V> may be absent from the deck (and `null` in it). A member `Position where` is
/// filled. Options are written in the order fallback, dimension, bounds, at_least, text.
template <class T>
class Schema : public SchemaBase {
  template <class M>
  using ValueOf = detail::ValueOf<M>;

 public:
  explicit Schema(std::string text) : SchemaBase(std::move(text)) {
    if constexpr (detail::HasWhere<T>)
      set_where_ = [](void* object, const Position& where) { static_cast<T*>(object)->where = where; };
  }

  /// Reads a struct; everything wrong is added to the findings, members that are wrong keep their initial
  /// value.
  T read(const Node& node, Findings& findings) const {
    T value{};
    read_into(&value, node, {findings, std::filesystem::path(node.where.file).parent_path(), "", ""});
    return value;
  }
  /// The same, throwing InputError with all findings.
  T read(const Node& node) const {
    Findings findings;
    T value = read(node, findings);
    findings.throw_if_any();
    return value;
  }
  /// Every parameter with its value, defaults included; read(echo(x)) is x.
  Node echo(const T& value) const { return echo_from(&value); }

  template <class C, class M>
  Schema& number(std::string name, M C::*member, NumberOptions o) {
    return add(std::move(name), member, number_kind(o.dimension, o.bounds), o);
  }
  template <class C, class M>
  Schema& integer(std::string name, M C::*member, IntegerOptions o) {
    using V = ValueOf<M>;
    auto fallback = o.fallback ? std::optional<V>(static_cast<V>(*o.fallback)) : std::nullopt;
    return add(std::move(name), member, integer_of<V>(o.bounds), ValueOptions<V>{fallback, o.text});
  }
  template <class C, class M>
  Schema& boolean(std::string name, M C::*member, ValueOptions<bool> o) {
    return add(std::move(name), member, boolean_kind(), o);
  }
  template <class C, class M>
  Schema& text(std::string name, M C::*member, ValueOptions<std::string> o) {
    return add(std::move(name), member, text_kind(), o);
  }
  using SchemaBase::text;
  template <class C, class M>
  Schema& one_of(std::string name, M C::*member, std::type_identity_t<Names<ValueOf<M>>> names,
                 std::type_identity_t<ValueOptions<ValueOf<M>>> o) {
    return add(std::move(name), member, name_of<ValueOf<M>>(std::move(names)), o);
  }
  /// A std::filesystem::path, made absolute from the deck's folder.
  template <class C, class M>
  Schema& file(std::string name, M C::*member, FileOptions o) {
    return add(std::move(name), member, file_kind(o.must_exist),
               ValueOptions<std::filesystem::path>{o.fallback, o.text});
  }
  template <class C, class M>
  Schema& point(std::string name, M C::*member, PointOptions o) {
    return add(std::move(name), member, point_kind(o.dimension), o);
  }
  /// [x, y] or the name of a point of the scene.
  template <class C, class M>
  Schema& spot(std::string name, M C::*member, ValueOptions<Spot> o) {
    return add(std::move(name), member, spot_kind(), o);
  }
  /// std::vector<Spot>.
  template <class C, class M>
  Schema& spots(std::string name, M C::*member, ManyOptions<std::vector<Spot>> o) {
    return many(std::move(name), member, list_of(spot_kind(), o.at_least), o);
  }
  template <class C, class M>
  Schema& points(std::string name, M C::*member, ManyOptions<std::vector<Vec2>> o) {
    return many(std::move(name), member, list_of(point_kind(dimension::length), o.at_least), o);
  }
  template <class C, class M>
  Schema& numbers(std::string name, M C::*member, ManyOptions<std::vector<double>> o) {
    return many(std::move(name), member, list_of(number_kind(o.dimension, o.bounds), o.at_least), o);
  }
  template <class C, class M>
  Schema& texts(std::string name, M C::*member, ManyOptions<std::vector<std::string>> o) {
    return many(std::move(name), member, list_of(text_kind(), o.at_least), o);
  }
  /// A nested struct; may be left out of the deck when everything in it may.
  template <class C, class M>
  Schema& section(std::string name, M C::*member, const Schema<ValueOf<M>>& schema, SectionOptions o = {}) {
    auto fallback = schema.has_required() ? std::nullopt : std::optional<Node>(Node::map());
    return bind(std::move(name), member, schema.kind(), {fallback, o.text.empty() ? schema.text() : o.text});
  }
  /// std::vector<V>; the entries are a Schema<V>, a Family (V its Choice) or any Kind<V>.
  template <class C, class M>
  Schema& list(std::string name, M C::*member, Kind<typename ValueOf<M>::value_type> item,
               std::type_identity_t<ManyOptions<ValueOf<M>>> o) {
    return many(std::move(name), member, list_of(std::move(item), o.at_least), o);
  }
  /// std::vector<std::pair<std::string, V>> (order of the deck) or std::map<std::string, V>.
  template <class C, class M>
  Schema& map(std::string name, M C::*member, Kind<typename ValueOf<M>::value_type::second_type> item,
              std::type_identity_t<ManyOptions<ValueOf<M>>> o) {
    return many(std::move(name), member, map_of<ValueOf<M>>(std::move(item), o.at_least), o);
  }
  /// A member of a family; the fallback is its name.
  template <class C, class M, class F>
  Schema& choice(std::string name, M C::*member, const F& family, ValueOptions<std::string> o) {
    auto fallback = o.fallback ? std::optional<Node>(Node::scalar(*o.fallback)) : std::nullopt;
    return bind(std::move(name), member, family.kind(), {fallback, o.text});
  }
  /// Any other kind of value.
  template <class C, class M>
  Schema& value(std::string name, M C::*member, Kind<ValueOf<M>> kind,
                std::type_identity_t<ValueOptions<ValueOf<M>>> o) {
    return add(std::move(name), member, kind, o);
  }
  /// A Node, copied as it stands (parameter lists of another library); null when absent.
  template <class C, class M>
  Schema& passthrough(std::string name, M C::*member, SectionOptions o) {
    return bind(std::move(name), member, anything_kind(), {Node{}, o.text});
  }
  /// A rule across keys: (const T&, Position, Findings&); runs when each key by itself is right.
  template <class Check>
  Schema& check(Check rule) {
    checks_.push_back([rule](const void* object, const Position& where, Findings& findings) {
      rule(*static_cast<const T*>(object), where, findings);
    });
    return *this;
  }

  Kind<T> kind() const {
    auto schema = std::make_shared<const Schema>(*this);
    auto read = [schema](const Node& node, const Reading& reading) -> std::optional<T> {
      T value{};
      return schema->read_into(&value, node, reading) ? std::optional<T>(std::move(value)) : std::nullopt;
    };
    auto echo = [schema](const T& value) { return schema->echo(value); };
    return {KindInfo{.form = KindInfo::Form::section, .section = schema}, read, echo};
  }

 private:
  struct Declaration {
    std::optional<Node> fallback;
    std::string text;
  };

  template <class C, class M, class O>
  Schema& add(std::string name, M C::*member, const Kind<ValueOf<M>>& kind, const O& o) {
    auto fallback = detail::fallback_node<ValueOf<M>>(kind, o.fallback);
    return bind(std::move(name), member, kind, {std::move(fallback), o.text});
  }

  template <class C, class M, class O>
  Schema& many(std::string name, M C::*member, const Kind<ValueOf<M>>& kind, const O& o) {
    auto fallback = detail::fallback_node<ValueOf<M>>(kind, o.fallback);
    if (!fallback && o.at_least == 0 && !detail::Unwrap<M>::is_optional) fallback = kind.echo({});
    return bind(std::move(name), member, kind, {std::move(fallback), o.text});
  }

  template <class C, class M>
  Schema& bind(std::string name, M C::*member, Kind<ValueOf<M>> kind, Declaration d) {
    static_assert(std::derived_from<T, C>, "the member belongs to another struct");
    constexpr bool optional = detail::Unwrap<M>::is_optional;
    Parameter parameter{std::move(name), std::move(d.text), kind.info, std::move(d.fallback), optional};
    if (optional) parameter.fallback.reset();
    auto read = [member, kind](void* object, const Node& node, const Reading& reading) {
      auto value = kind.read(node, reading);
      if (value) static_cast<T*>(object)->*member = std::move(*value);
      return value.has_value();
    };
    auto echo = [member, kind](const void* object) -> std::optional<Node> {
      const M& value = static_cast<const T*>(object)->*member;
      if constexpr (optional)
        return value ? std::optional<Node>(kind.echo(*value)) : std::nullopt;
      else
        return kind.echo(value);
    };
    declare({std::move(parameter), read, echo});
    return *this;
  }
};

}  // namespace dda
