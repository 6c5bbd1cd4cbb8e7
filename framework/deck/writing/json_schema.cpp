#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/deck/family.hpp"

namespace dda {

namespace {

/// A default value as JSON: texts become numbers where the kind says so.
Json value_of(const Node& node, const KindInfo& kind) {
  using enum KindInfo::Form;
  if (node.is_sequence() || node.is_map()) {
    Json json = node.is_map() ? Json::object() : Json::array();
    const KindInfo item = kind.item ? *kind.item : KindInfo{.form = kind.form == point ? number : anything};
    for (const Node& child : node.items) json.push_back(value_of(child, item));
    for (const NodeEntry& entry : node.entries) json[entry.key] = value_of(entry.value, item);
    return json;
  }
  if (node.is_null()) return nullptr;
  if (kind.form == number) return std::stod(node.text);
  if (kind.form == integer) return std::stoll(node.text);
  if (kind.form == boolean) return node.text == "true";
  return node.text;
}

void add_bounds(Json& json, const Bounds& bounds) {
  if (!std::isinf(bounds.low)) json[bounds.low_open ? "exclusiveMinimum" : "minimum"] = bounds.low;
  if (!std::isinf(bounds.high)) json[bounds.high_open ? "exclusiveMaximum" : "maximum"] = bounds.high;
}

/// Walks a declaration; a family is written once, under "definitions", so that families may contain each
/// other.
class Writer {
 public:
  Json object(const SchemaBase& schema) {
    Json json = {{"type", "object"}, {"description", schema.text()}, {"properties", Json::object()}};
    Json required = Json::array();
    for (const Parameter& parameter : schema.parameters()) {
      json["properties"][parameter.name] = property(parameter);
      if (parameter.is_required()) required.push_back(parameter.name);
    }
    if (!required.empty()) json["required"] = required;
    json["additionalProperties"] = false;
    return json;
  }

  const Json& definitions() const { return definitions_; }

 private:
  Json property(const Parameter& parameter) {
    Json json = value(parameter.kind);
    // Draft 7 ignores what stands beside a $ref.
    if (json.contains("$ref")) json = {{"allOf", Json::array({json})}};
    json["description"] = parameter.text;
    if (parameter.fallback) json["default"] = value_of(*parameter.fallback, parameter.kind);
    if (parameter.may_be_absent)
      return {{"description", parameter.text}, {"anyOf", {json, {{"type", "null"}}}}};
    return json;
  }

  Json value(const KindInfo& kind) {
    using enum KindInfo::Form;
    switch (kind.form) {
      case number:
      case integer:
        return bounded(kind);
      case boolean:
        return {{"type", "boolean"}};
      case text:
        return {{"type", Json::array({"string", "number", "boolean"})}};
      case file:
        return {{"type", "string"}};
      case name:
        return {{"enum", kind.names}};
      case point:
        return point_of(kind);
      case spot:
        return {{"anyOf", {point_of(kind), {{"type", "string"}}}}};
      case section:
        return object(*kind.section);
      case family:
        return reference(*kind.family);
      case list:
        return list_or_words(kind);
      case map:
        return {{"type", "object"},
                {"additionalProperties", value(*kind.item)},
                {"minProperties", kind.at_least}};
      case anything:
        break;
    }
    return Json::object();
  }

  Json list_or_words(const KindInfo& kind) {
    Json list{{"type", "array"}, {"items", value(*kind.item)}, {"minItems", kind.at_least}};
    if (kind.names.empty()) return list;
    return {{"anyOf", Json::array({Json{{"enum", kind.names}}, std::move(list)})}};
  }

  /// Bounds say nothing of texts.
  static Json number_or_expression(const char* number) { return Json::array({number, "string"}); }

  static Json bounded(const KindInfo& kind) {
    Json json = {{"type", number_or_expression(kind.form == KindInfo::Form::integer ? "integer" : "number")}};
    if (kind.dimension != dimension::none) json["unit"] = label(kind.dimension);
    add_bounds(json, kind.bounds);
    return json;
  }

  static Json point_of(const KindInfo& kind) {
    Json json = {{"type", "array"},
                 {"items", {{"type", number_or_expression("number")}}},
                 {"minItems", 2},
                 {"maxItems", 2}};
    if (kind.dimension != dimension::none) json["unit"] = label(kind.dimension);
    return json;
  }

  Json reference(const FamilyBase& family) {
    if (!definitions_.contains(family.name())) {
      definitions_[family.name()] = Json::object();  // ends the recursion of a family that contains itself
      Json definition = members(family);
      definitions_[family.name()] = std::move(definition);
    }
    return {{"$ref", "#/definitions/" + family.name()}};
  }

  /// Told apart by `type`, so that an editor offers and judges the keys of the member that was meant.
  Json members(const FamilyBase& family) {
    Json bare = Json::array(), names = Json::array(), cases = Json::array();
    for (const FamilyMember* member : family.entries()) {
      if (!member->schema->has_required()) bare.push_back(member->name);
      names.push_back(member->name);
      cases.push_back(
          {{"if", {{"properties", {{"type", {{"const", member->name}}}}}}}, {"then", tagged(*member)}});
    }
    const Json one_of_them{
        {"required", {"type"}}, {"properties", {{"type", {{"enum", names}}}}}, {"allOf", cases}};
    Json out{{"description", family.text()}};
    if (bare.empty()) {
      out["type"] = "object";
      out.update(one_of_them);
    } else {
      out["type"] = {"object", "string"};
      out["if"] = {{"type", "string"}};
      out["then"] = {{"enum", bare}};
      out["else"] = one_of_them;
    }
    return out;
  }

  Json tagged(const FamilyMember& member) {
    Json json = object(*member.schema);
    json["properties"]["type"] = {{"const", member.name}};
    json["required"].push_back("type");
    return json;
  }

  Json definitions_ = Json::object();
};

}  // namespace

Json SchemaBase::json_schema() const {
  Writer writer;
  Json json = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"$id", "urn:ddapath:deck"}};
  json.update(writer.object(*this));
  json["definitions"] = writer.definitions();
  return json;
}

}  // namespace dda
