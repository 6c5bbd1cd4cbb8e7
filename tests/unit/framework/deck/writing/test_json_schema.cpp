#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/framework/deck/deck_example.hpp"

namespace dda {
namespace {

TEST(JsonSchema, DescribesParameters) {
  const Json json = example::deck_schema().json_schema();
  const Json& properties = json.at("properties");
  EXPECT_EQ(json.at("$schema"), "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(json.at("required"), Json::array({"young_modulus"}));
  EXPECT_EQ(json.at("additionalProperties"), false);
  EXPECT_EQ(properties.at("young_modulus").at("exclusiveMinimum"), 0);
  EXPECT_EQ(properties.at("young_modulus").at("unit"), "F/L²");
  EXPECT_EQ(properties.at("poisson_ratio").at("maximum"), 0.5);
  EXPECT_EQ(properties.at("poisson_ratio").at("default"), 0.2);
  EXPECT_EQ(properties.at("state").at("enum"), Json::array({"plane_stress", "plane_strain"}));
  EXPECT_EQ(properties.at("record").at("properties").at("every").at("default"), 10);
  EXPECT_EQ(properties.at("curves").at("additionalProperties").at("minItems"), 2);
}

TEST(JsonSchema, FamiliesAreDefinitions) {
  const Json json = example::deck_schema().json_schema();
  const Json& list = json.at("definitions").at("test_law").at("anyOf");
  EXPECT_EQ(json.at("properties").at("layers").at("items").at("$ref"), "#/definitions/test_law");
  ASSERT_EQ(list.size(), 3u) << "two members and the names that need no parameters";
  EXPECT_EQ(list[1].at("properties").at("type").at("const"), "softening");
  EXPECT_EQ(list[1].at("required"), Json::array({"strength", "energy", "type"}));
  EXPECT_EQ(list[2].at("enum"), Json::array({"bonded"}));
}

struct Composite;
struct Inner {
  std::vector<Choice<Composite>> parts;
};
struct Composite {};

TEST(JsonSchema, AFamilyMayContainItself) {
  Family<Composite> family("self", "Made of itself.");
  family.add("sum", Schema<Inner>("A sum.").list("parts", &Inner::parts, family, {.text = "What is summed."}),
             [](const Inner&) { return std::make_unique<Composite>(); });
  const Json json = family.find("sum")->schema->json_schema();
  EXPECT_EQ(
      json.at("definitions").at("self").at("anyOf")[0].at("properties").at("parts").at("items").at("$ref"),
      "#/definitions/self");
}

}  // namespace
}  // namespace dda
