#include <gmock/gmock.h>

#include <regex>
#include <stack>

#include "framework/files/run/xdmf.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const XdmfSizes sizes{2, 7, 11, 1, true};

std::vector<XdmfStep> two_steps() {
  return {{1, 0.5, {{"stress", FieldPlace::block, 3}}},
          {2, 1.5, {{"displacement", FieldPlace::block_vertex, 3}, {"damage", FieldPlace::segment, 1}}}};
}

/// Whether every element is closed, in order.
bool is_balanced(const std::string& text) {
  const std::regex tag("<(/?)([A-Za-z]+)[^>]*?(/?)>");
  std::stack<std::string> open;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    if ((*it)[3] == "/") continue;
    if ((*it)[1] != "/") {
      open.push((*it)[2]);
    } else if (open.empty() || open.top() != (*it)[2]) {
      return false;
    } else {
      open.pop();
    }
  }
  return open.empty();
}

TEST(Xdmf, IsWellFormed) {
  EXPECT_TRUE(is_balanced(xdmf_text(sizes, two_steps())));
  EXPECT_TRUE(is_balanced(xdmf_text(sizes, {})));
}

TEST(Xdmf, SizesAreThoseOfTheDatasets) {
  const std::string text = xdmf_text(sizes, two_steps());
  EXPECT_THAT(text, HasSubstr("Dimensions=\"7 3\">fields/mesh.h5:/mesh/vertices"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"11\">fields/mesh.h5:/mesh/mixed"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"2 3\">fields/000001.h5:/stress"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"7 3\">fields/000002.h5:/displacement"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"1\">fields/000002.h5:/segments/damage"));
  EXPECT_THAT(text, HasSubstr("<Time Value=\"1.5\"/>"));
}

TEST(Xdmf, NormalAndSlidingComponentsAreNamed) {
  const std::string text =
      xdmf_text({2, 7, 11, 4, true}, {{1, 0.5, {{"opening", FieldPlace::segment, 3, "n s"}}}});
  EXPECT_TRUE(is_balanced(text));
  EXPECT_THAT(text, HasSubstr("Name=\"opening_n\" AttributeType=\"Scalar\""));
  EXPECT_THAT(text, HasSubstr("Format=\"XML\">0 0 1 1 4 1</DataItem>"));
  EXPECT_THAT(text, HasSubstr("Name=\"opening_s\" AttributeType=\"Scalar\""));
  EXPECT_THAT(text, HasSubstr("Format=\"XML\">0 1 1 1 4 1</DataItem>"));
  EXPECT_THAT(text, Not(HasSubstr("\"Vector\"")));
}

TEST(Xdmf, NoInterfaceGridWithoutSegments) {
  XdmfSizes blocks_only = sizes;
  blocks_only.segments = 0;
  EXPECT_THAT(xdmf_text(blocks_only, two_steps()), Not(HasSubstr("interfaces")));
}

/// Where cracks have cut blocks the step has its own geometry, and no other step is told of it.
TEST(Xdmf, CutBlocksAndCracksAreGridsOfTheirOwn) {
  std::vector<XdmfStep> steps = two_steps();
  steps[1].cuts = {.parts = 2, .vertices = 8, .mixed = 12, .whole = 10, .pieces = 4};
  steps[1].fields.push_back({"stress", FieldPlace::part, 3});
  steps[1].fields.push_back({"displacement", FieldPlace::part_vertex, 3});
  steps[1].fields.push_back({"opening", FieldPlace::crack, 3, "n s"});
  steps[1].fields.push_back({"displacement", FieldPlace::crack_end, 3});
  const std::string text = xdmf_text(sizes, steps);
  EXPECT_TRUE(is_balanced(text));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"11\">fields/mesh.h5:/mesh/mixed"));
  EXPECT_THAT(text, HasSubstr("NumberOfElements=\"2\"><DataItem Format=\"HDF\" NumberType=\"Int\" "
                              "Precision=\"8\" Dimensions=\"10\">fields/000002.h5:/parts/whole"));
  EXPECT_THAT(text, HasSubstr("<Grid Name=\"parts\" GridType=\"Uniform\">"));
  EXPECT_THAT(text, HasSubstr("NumberOfElements=\"2\"><DataItem Format=\"HDF\" NumberType=\"Int\" "
                              "Precision=\"8\" Dimensions=\"12\">fields/000002.h5:/parts/mixed"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"8 3\">fields/000002.h5:/parts/vertices"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"2 3\">fields/000002.h5:/parts/stress"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"8 3\">fields/000002.h5:/parts/displacement"));
  EXPECT_THAT(text, HasSubstr("<Grid Name=\"cracks\" GridType=\"Uniform\">"));
  EXPECT_THAT(text, HasSubstr("NodesPerElement=\"2\" NumberOfElements=\"4\""));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"8 3\">fields/000002.h5:/cracks/ends"));
  EXPECT_THAT(text, HasSubstr("Format=\"XML\">0 0 1 1 4 1</DataItem>"));
  EXPECT_THAT(text, Not(HasSubstr("fields/000001.h5:/parts")));
}

TEST(Xdmf, NamesAreEscaped) {
  const std::string text = xdmf_text(sizes, {{1, 1, {{"<\"x\">", FieldPlace::block, 1}}}});
  EXPECT_THAT(text, HasSubstr(".h5:/&lt;"));
  EXPECT_THAT(text, HasSubstr("&lt;&quot;x&quot;>"));
}

}  // namespace
}  // namespace dda
