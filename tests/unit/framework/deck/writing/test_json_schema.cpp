#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/framework/deck/deck_example.hpp"

namespace dda {
namespace {

TEST(JsonSchema, DescribesParameters) {
  const Json json = example::deck_schema().json_schema();
  const Json& properties = json.at("properties");
  EXPECT_EQ(json.at("$schema"), "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(json.at("$id"), "urn:ddapath:deck");
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

TEST(JsonSchema, FamiliesAreDefinitionsWhoseMembersAreToldByType) {
  const Json json = example::deck_schema().json_schema();
  const Json& family = json.at("definitions").at("test_law");
  EXPECT_EQ(json.at("properties").at("layers").at("items").at("$ref"), "#/definitions/test_law");
  EXPECT_EQ(family.at("then").at("enum"), Json::array({"bonded"}))
      << "a name alone, of what needs no parameters";
  const Json& tagged = family.at("else");
  EXPECT_EQ(tagged.at("required"), Json::array({"type"}));
  EXPECT_EQ(tagged.at("properties").at("type").at("enum"), Json::array({"bonded", "softening"}));
  const Json& softening = tagged.at("allOf").at(1);
  EXPECT_EQ(softening.at("if").at("properties").at("type").at("const"), "softening");
  EXPECT_EQ(softening.at("then").at("required"), Json::array({"strength", "energy", "type"}));
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
  const Json& sum = json.at("definitions").at("self").at("else").at("allOf")[0].at("then");
  EXPECT_EQ(sum.at("properties").at("parts").at("items").at("$ref"), "#/definitions/self");
}

}  // namespace
}  // namespace dda
