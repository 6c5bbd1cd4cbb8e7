#include <gmock/gmock.h>

#include "continuation/control/control.hpp"
#include "continuation/detour/increment/load_solver.hpp"
#include "continuation/integrator/integrator.hpp"
#include "continuation/linear/direct/direct_solver.hpp"
#include "meshing/subdivision/subdivision.hpp"
#include "models/contact/contact_law.hpp"
#include "models/crack_direction/direction.hpp"
#include "models/gauge/gauge.hpp"
#include "models/interface/law.hpp"
#include "models/kinematics/kinematics.hpp"
#include "models/load/load.hpp"
#include "models/material/material.hpp"
#include "models/time_function/time_function.hpp"
#include "models/treatment/treatment.hpp"
#include "studies/dda/case/deck/deck.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

/// A family with reading and echoing as one function, text to text.
struct FamilyUnderTest {
  const FamilyBase* family;
  std::function<std::string(const std::string&)> echo;  ///< throws InputError
};

template <class Product, class... Context>
FamilyUnderTest under_test(const Family<Product, Context...>& family) {
  return {&family, [&family](const std::string& yaml) {
            return to_yaml(family.choose(parse_yaml(yaml, "deck.yaml")).echo());
          }};
}

std::vector<FamilyUnderTest> known_families() {
  return {under_test(materials()),        under_test(interface_laws()), under_test(treatments()),
          under_test(gauges()),           under_test(loads()),          under_test(direct_solvers()),
          under_test(crack_directions()), under_test(controls()),       under_test(subdivisions()),
          under_test(load_solvers()),     under_test(contact_laws()),   under_test(integrators()),
          under_test(time_functions()),   under_test(kinematics())};
}

struct Entry {
  FamilyUnderTest of;
  const FamilyMember* member;
};

std::vector<Entry> every_entry() {
  std::vector<Entry> out;
  for (const FamilyUnderTest& family : known_families())
    for (const FamilyMember* member : family.family->entries()) out.push_back({family, member});
  return out;
}

/// Every parameter has a text, and so has everything below it.
void expect_documented(const SchemaBase& schema, const std::string& place) {
  EXPECT_FALSE(schema.text().empty()) << place;
  for (const Parameter& parameter : schema.parameters()) {
    const std::string at = place + "." + parameter.name;
    ASSERT_FALSE(parameter.text.empty()) << at;
    EXPECT_EQ(parameter.text.back(), '.') << at;
    EXPECT_FALSE(parameter.kind.words().empty()) << at;
    const KindInfo* kind = &parameter.kind;
    while (kind->item) kind = kind->item.get();
    if (kind->section) expect_documented(*kind->section, at);
  }
}

TEST(Families, EachIsUnderContract) {
  std::vector<const FamilyBase*> known;
  for (const FamilyUnderTest& family : known_families()) known.push_back(family.family);
  EXPECT_THAT(known, testing::UnorderedElementsAreArray(all_families()));
  for (const FamilyBase* family : all_families()) {
    EXPECT_FALSE(family->entries().empty()) << family->name();
    EXPECT_FALSE(family->text().empty()) << family->name();
  }
}

TEST(Families, TheWholeDeckIsDocumented) { expect_documented(deck_schema(), "deck"); }

class EntryContract : public testing::TestWithParam<Entry> {
 protected:
  const FamilyMember& member() const { return *GetParam().member; }
  std::string echo(const std::string& yaml) const { return GetParam().of.echo(yaml); }
  Node parameters() {
    Node out = sample(*member().schema, random_, square_names());
    out.set("type", Node::scalar(member().name));
    return out;
  }
  std::string refusal(const Node& node) const {
    try {
      echo(to_yaml(node));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  Random random_{26};
};

TEST_P(EntryContract, IsDocumented) { expect_documented(*member().schema, member().name); }

TEST_P(EntryContract, EchoReadsBackToItself) {
  for (int i = 0; i < 20; ++i) {
    const Node given = parameters();
    const std::string once = echo(to_yaml(given));
    EXPECT_EQ(echo(once), once);
    const Node back = parse_yaml(once, "echo.yaml");
    for (const auto& [key, where, value] : given.entries) {
      if (!back.is_map()) continue;  // a member without parameters is its bare name
      ASSERT_NE(back.find(key), nullptr) << key << " in\n" << once;
      EXPECT_EQ(*back.find(key), value) << key << " in\n" << once;
    }
  }
}

TEST_P(EntryContract, EchoHoldsEveryDefault) {
  const Node back = parse_yaml(echo(to_yaml(parameters())), "echo.yaml");
  for (const Parameter& parameter : member().schema->parameters()) {
    if (parameter.may_be_absent) continue;
    EXPECT_NE(back.find(parameter.name), nullptr) << parameter.name;
  }
}

TEST_P(EntryContract, UnknownKeyIsRefused) {
  Node node = parameters();
  node.set("no_such_key", Node::number(1));
  EXPECT_THAT(refusal(node), testing::HasSubstr("unknown parameter 'no_such_key'"));
}

TEST_P(EntryContract, MissingParameterIsNamed) {
  const Node whole = parameters();
  for (const Parameter& parameter : member().schema->parameters()) {
    if (!parameter.is_required()) continue;
    Node node = whole;
    std::erase_if(node.entries, [&](const NodeEntry& entry) { return entry.key == parameter.name; });
    EXPECT_THAT(refusal(node), testing::HasSubstr("missing parameter '" + parameter.name + "'"));
  }
}

TEST_P(EntryContract, NumbersOutOfBoundsAreRefused) {
  const Node whole = parameters();
  for (const Parameter& parameter : member().schema->parameters()) {
    if (parameter.kind.form != KindInfo::Form::number) continue;
    for (const double end : {parameter.kind.bounds.low, parameter.kind.bounds.high}) {
      if (!std::isfinite(end)) continue;
      Node node = whole;
      node.set(parameter.name, Node::number(end == parameter.kind.bounds.low ? end - 1 : end + 1));
      EXPECT_THAT(refusal(node), testing::HasSubstr(parameter.name + ": must be"));
    }
    Node node = whole;
    node.set(parameter.name, Node::scalar(".nan"));
    EXPECT_NE(refusal(node), "") << parameter.name << " takes NaN";
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EntryContract, testing::ValuesIn(every_entry()), [](const auto& chosen) {
  return chosen.param.of.family->name() + "_" + chosen.param.member->name;
});

class SubdivisionContract : public testing::TestWithParam<std::string> {
 protected:
  /// A region `first` of area 0.5 or 0.75, beside the rest of the unit square.
  static Layout layout(const std::string& first, const std::string& rest) {
    return layout_of(
        scene_schema().read(parse_yaml("regions:\n  - {name: first, material: stone, vertices: " + first +
                                           "}\n  - {name: rest, material: mortar, vertices: " + rest + "}\n",
                                       "deck.yaml")));
  }
  Cells divide(const Layout& whole) const {
    Random random(27);
    const Node parameters = sample(*subdivisions().find(GetParam())->schema, random, square_names());
    return subdivisions().choose(GetParam(), parameters).make()->divide(whole);
  }
  void expect_filled(const Layout& whole, double area_of_first) const {
    const Cells made = divide(whole), again = divide(whole);
    ASSERT_EQ(made.cells.size(), again.cells.size());
    double area[2] = {0, 0};
    for (std::size_t i = 0; i < made.cells.size(); ++i) {
      const Cell& cell = made.cells[i];
      EXPECT_GT(signed_area(cell.outline), 0) << "counter-clockwise";
      area[cell.region] += signed_area(cell.outline);
      EXPECT_EQ(cell.outline.vertices, again.cells[i].outline.vertices);
      EXPECT_EQ(cell.region, again.cells[i].region);
    }
    EXPECT_NEAR(area[0], area_of_first, 1e-12);
    EXPECT_NEAR(area[1], 1 - area_of_first, 1e-12);
  }
};

TEST_P(SubdivisionContract, FillsEveryRegionTheSameWayEachTime) {
  expect_filled(layout("[[0, 0], [0.6, 0], [0.4, 1], [0, 1]]", "[[0.6, 0], [1, 0], [1, 1], [0.4, 1]]"), 0.5);
}

TEST_P(SubdivisionContract, FillsOrRefusesARegionWithAReentrantCorner) {
  const Layout corner = layout("[[0, 0], [1, 0], [1, 0.5], [0.5, 0.5], [0.5, 1], [0, 1]]",
                               "[[0.5, 0.5], [1, 0.5], [1, 1], [0.5, 1]]");
  try {
    expect_filled(corner, 0.75);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("four corners")) << "only a grid may refuse it";
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, SubdivisionContract, testing::ValuesIn(names_of(subdivisions())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
