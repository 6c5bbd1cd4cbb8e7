#include <gmock/gmock.h>

#include <limits>
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

/// That the text names this array of a file of fields/, of this size.
auto HasArray(const std::string& size, const std::string& place) {
  return HasSubstr("Dimensions=\"" + size + "\">fields/" + place + "</DataItem>");
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
  EXPECT_THAT(text, HasArray("7 3", "mesh.h5:/mesh/vertices"));
  EXPECT_THAT(text, HasArray("11", "mesh.h5:/mesh/mixed"));
  EXPECT_THAT(text, HasArray("2 3", "000001.h5:/stress"));
  EXPECT_THAT(text, HasArray("7 3", "000002.h5:/displacement"));
  EXPECT_THAT(text, HasArray("1", "000002.h5:/segments/damage"));
  EXPECT_THAT(text, HasSubstr("<Time Value=\"1.5\"/>"));
}

TEST(Xdmf, NormalAndSlidingComponentsAreNamed) {
  const std::string text =
      xdmf_text({2, 7, 11, 4, true}, {{1, 0.5, {{"opening", FieldPlace::segment, 3, "n s"}}}});
  EXPECT_TRUE(is_balanced(text));
  EXPECT_THAT(text, HasSubstr("Name=\"opening_n\" AttributeType=\"Scalar\""));
  EXPECT_THAT(text, HasArray("4", "000001.h5:/segments/opening_n"));
  EXPECT_THAT(text, HasSubstr("Name=\"opening_s\" AttributeType=\"Scalar\""));
  EXPECT_THAT(text, HasArray("4", "000001.h5:/segments/opening_s"));
  EXPECT_THAT(text, Not(HasSubstr("\"Vector\"")));
  EXPECT_THAT(text, Not(HasSubstr("HyperSlab"))) << "Xdmf3 takes none";
}

TEST(Xdmf, StressesAndStrainsAreTensors) {
  const std::string text =
      xdmf_text(sizes, {{1,
                         0.5,
                         {{"stress", FieldPlace::block, 3, "xx yy xy"},
                          {"strain", FieldPlace::block, 3, "xx yy 2xy"},
                          {"stress_at_vertices", FieldPlace::block_vertex, 3, "xx yy xy"}}}});
  EXPECT_THAT(text, HasSubstr("Name=\"stress\" AttributeType=\"Tensor\" Center=\"Cell\""));
  EXPECT_THAT(text, HasArray("2 9", "000001.h5:/stress_tensor"));
  EXPECT_THAT(text, HasArray("2 9", "000001.h5:/strain_tensor"));
  EXPECT_THAT(text, HasSubstr("Name=\"stress_at_vertices\" AttributeType=\"Tensor\" Center=\"Node\""));
  EXPECT_THAT(text, HasArray("7 9", "000001.h5:/stress_at_vertices_tensor"));
}

TEST(Xdmf, NumbersOfAStepAndNamesOfRegionsAreFieldData) {
  XdmfSizes named = sizes;
  named.regions = {"beam (concrete)", "a & b"};
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::string text =
      xdmf_text(named, {{1, 1, {}, {}, {{"load_factor", 0.1}, {"<u>", -2}, {"none", none}}},
                        {2, 2, {}, {}, {{"load_factor", 0.2}}}});
  EXPECT_TRUE(is_balanced(text));
  const auto field_data = [](const std::string& name, const std::string& value) {
    return "Name=\"" + name +
           "\" AttributeType=\"Scalar\" Center=\"Grid\"><DataItem Format=\"XML\" NumberType=\"Float\" " +
           "Precision=\"8\" Dimensions=\"1\">" + value + "</DataItem>";
  };
  EXPECT_THAT(text, HasSubstr(field_data("load_factor", "0.1")));
  EXPECT_THAT(text, HasSubstr(field_data("load_factor", "0.2")));
  EXPECT_THAT(text, HasSubstr(field_data("&lt;u>", "-2")));
  EXPECT_THAT(text, HasSubstr(field_data("region 0: beam (concrete)", "0")));
  EXPECT_THAT(text, HasSubstr(field_data("region 1: a &amp; b", "1")));
  EXPECT_THAT(text, Not(HasSubstr("nan"))) << "Xdmf2 reads it as garbage";
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
  EXPECT_THAT(text, HasArray("11", "mesh.h5:/mesh/mixed"));
  EXPECT_THAT(text, HasSubstr("NumberOfElements=\"2\"><DataItem Format=\"HDF\" NumberType=\"Int\" "
                              "Precision=\"8\" Dimensions=\"10\">fields/000002.h5:/parts/whole"));
  EXPECT_THAT(text, HasSubstr("<Grid Name=\"parts\" GridType=\"Uniform\">"));
  EXPECT_THAT(text, HasSubstr("NumberOfElements=\"2\"><DataItem Format=\"HDF\" NumberType=\"Int\" "
                              "Precision=\"8\" Dimensions=\"12\">fields/000002.h5:/parts/mixed"));
  EXPECT_THAT(text, HasArray("8 3", "000002.h5:/parts/vertices"));
  EXPECT_THAT(text, HasArray("2 3", "000002.h5:/parts/stress"));
  EXPECT_THAT(text, HasArray("8 3", "000002.h5:/parts/displacement"));
  EXPECT_THAT(text, HasSubstr("<Grid Name=\"cracks\" GridType=\"Uniform\">"));
  EXPECT_THAT(text, HasSubstr("NodesPerElement=\"2\" NumberOfElements=\"4\""));
  EXPECT_THAT(text, HasArray("8 3", "000002.h5:/cracks/ends"));
  EXPECT_THAT(text, HasArray("4", "000002.h5:/cracks/opening_n"));
  EXPECT_THAT(text, HasArray("2", "000002.h5:/parts/region"));
  EXPECT_THAT(text, Not(HasSubstr("fields/000001.h5:/parts")));
}

TEST(Xdmf, NamesAreEscaped) {
  const std::string text = xdmf_text(sizes, {{1, 1, {{"<\"x\">", FieldPlace::block, 1}}}});
  EXPECT_THAT(text, HasSubstr(".h5:/&lt;"));
  EXPECT_THAT(text, HasSubstr("&lt;&quot;x&quot;>"));
}

}  // namespace
}  // namespace dda
