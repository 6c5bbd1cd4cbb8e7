#include "studies/dda/shell/editor_schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "studies/dda/case/deck/deck_tree.hpp"
#include "studies/dda/case/deck/written_deck.hpp"
#include "studies/dda/sweep/description/derived_columns.hpp"

namespace dda {
namespace {

constexpr std::string_view definitions = "#/definitions/";
constexpr std::string_view partial = "partial-";

Json reference_to(std::string_view name) { return {{"$ref", fmt::format("{}{}", definitions, name)}}; }

Json relaxed(const Json& schema);

/// Every key of the members of a family: what may stand in a map whose `type` is that of the deck below.
Json keys_of_members(const Json& cases) {
  Json names = Json::array();
  for (const Json& one : cases)
    for (const auto& [name, ignored] : one.at("then").at("properties").items())
      if (std::ranges::find(names, Json(name)) == names.end()) names.push_back(name);
  return {{"enum", std::move(names)}};
}

/// Null drops what the deck below says.
Json or_null(const Json& schema) {
  return {{"if", {{"not", {{"type", "null"}}}}}, {"then", relaxed(schema)}};
}

Json relaxed_value(const std::string& key, const Json& value) {
  if (key == "$ref")
    return fmt::format("{}{}{}", definitions, partial, value.get<std::string>().substr(definitions.size()));
  if (key == "properties") {
    Json out = Json::object();
    for (const auto& [name, schema] : value.items())
      out[name] = schema.contains("default") ? or_null(schema) : relaxed(schema);
    return out;
  }
  if (key == "additionalProperties" && value.is_object()) return or_null(value);
  if (key == "anyOf" || key == "allOf") {
    Json out = Json::array();
    for (const Json& schema : value) out.push_back(relaxed(schema));
    return out;
  }
  return key == "then" || key == "else" ? relaxed(value) : value;  // lists are whole
}

/// Without what must be there: keys of maps add up with those of the deck below.
Json relaxed(const Json& schema) {
  Json out = Json::object();
  for (const auto& [key, value] : schema.items())
    if (key != "required" && key != "minProperties") out[key] = relaxed_value(key, value);
  if (out.contains("if") && out["if"].contains("properties")) out["if"]["required"] = {"type"};
  const bool is_family = out.contains("allOf") && out["allOf"].front().contains("then");
  if (is_family) out["propertyNames"] = keys_of_members(out["allOf"]);
  return out;
}

/// Values of a key that a sweep varies: a list, or a range.
Json axis() {
  constexpr const char* integer = R"([-+]?\d+)";
  constexpr const char* number = R"([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)";
  const std::string range =
      fmt::format(R"(^\s*({0}\s*\.\.\s*{0}|{1}\s*\.\.\s*{1}\s+(step\s+{1}|log\s+{0}))\s*$)", integer, number);
  return {{"type", {"array", "string"}}, {"minItems", 1}, {"pattern", range}};
}

Json columns_of_sweeps() {
  return {
      {"type", "object"},
      {"propertyNames", {{"pattern", "^[A-Za-z_][A-Za-z_0-9]*$"}, {"not", {{"enum", reserved_columns()}}}}},
      {"additionalProperties", {{"type", {"string", "number"}}}}};
}

/// Keys that vary together.
Json zip_of(const Json& varied) {
  return {{"type", "object"},
          {"minProperties", 1},
          {"properties", {{"deck", {{"type", "array"}, {"minItems", 1}, {"items", {{"type", "string"}}}}}}},
          {"additionalProperties", axis()},
          {"propertyNames", varied}};
}

Json sweep_of(const Json& deck) {
  std::vector<std::string> keys{"deck", "seed"};
  for (const auto& [key, ignored] : deck["properties"].items())
    if (key != "sweep" && key != "extends") keys.push_back(key);
  const Json varied = {{"pattern", fmt::format("^({})($|\\.)", fmt::join(keys, "|"))}};
  const Json zip = zip_of(varied);
  return {{"description", deck["properties"]["sweep"]["description"]},
          {"type", {"object", "null"}},
          {"properties",
           {{"deck", {{"type", {"string", "array"}}, {"minItems", 1}, {"items", {{"type", "string"}}}}},
            {"columns", columns_of_sweeps()},
            {"zip",
             {{"type", {"object", "array"}},
              {"if", {{"type", "array"}}},
              {"then", {{"items", zip}}},
              {"else", zip}}}}},
          {"additionalProperties", axis()},
          {"propertyNames", {{"anyOf", {{{"enum", {"columns", "zip"}}}, varied}}}}};
}

/// A map with an entry that obeys a schema.
Json with(const char* key, const Json& schema) {
  return {{"required", {key}}, {"properties", {{key, schema}}}};
}

/// Of a sweep that names its decks: whatever stands beside it belongs to them.
Json names_decks() {
  const Json has_deck{{"type", "object"}, {"required", {"deck"}}};
  const Json zips{{"anyOf", {has_deck, {{"type", "array"}, {"contains", has_deck}}}}};
  return with("sweep", {{"type", "object"}, {"anyOf", {has_deck, with("zip", zips)}}});
}

Json is_partial() {
  return {{"anyOf", {with("extends", {{"not", {{"type", "null"}}}}), with("sweep", {{"type", "object"}})}}};
}

/// Descriptions alone: the definitions judge.
Json described(const Json& properties) {
  Json out = Json::object();
  for (const auto& [key, schema] : properties.items()) out[key] = {{"description", schema["description"]}};
  return out;
}

}  // namespace

nlohmann::ordered_json schema_for_editors() {
  Json deck = written_deck_schema().json_schema();
  const Json anchors = {{std::string("^") + key_of_anchors, true}};
  Json all = deck["definitions"];
  const Json properties = described(deck["properties"]);
  Json out{{"$schema", deck["$schema"]}, {"$id", deck["$id"]}};
  for (const char* key : {"$schema", "$id", "definitions"}) deck.erase(key);
  deck["patternProperties"] = anchors;
  all["sweep"] = sweep_of(deck);
  deck["properties"]["sweep"] = {{"description", all["sweep"]["description"]},
                                 {"allOf", {reference_to("sweep")}}};
  const Json families = all;
  for (const auto& [name, family] : families.items())
    if (name != "sweep") all[std::string(partial) + name] = relaxed(family);
  all["partial-deck"] = relaxed(deck);
  all["partial-deck"]["properties"]["sweep"] = deck["properties"]["sweep"];
  out["type"] = "object";
  out["description"] = deck["description"];
  out["properties"] = properties;
  out["if"] = names_decks();
  out["then"] = {
      {"properties",
       {{"sweep", deck["properties"]["sweep"]}, {"title", deck["properties"]["title"]}, {"extends", true}}},
      {"patternProperties", anchors},
      {"additionalProperties", false}};
  out["else"] = {
      {"if", is_partial()}, {"then", reference_to("partial-deck")}, {"else", reference_to("deck")}};
  all["deck"] = std::move(deck);
  out["definitions"] = std::move(all);
  return out;
}

}  // namespace dda
