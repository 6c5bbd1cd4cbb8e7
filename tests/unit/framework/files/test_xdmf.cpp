#include <gmock/gmock.h>

#include <regex>
#include <stack>

#include "framework/files/xdmf.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const ResultsFile::Sizes sizes{2, 7, 11, 1, true};

std::vector<ResultsFile::StepEntry> two_steps() {
  return {{1, 0.5, {{"stress", "/field/000001/stress", FieldPlace::block, 3}}},
          {2,
           1.5,
           {{"displacement", "/field/000002/displacement", FieldPlace::block_vertex, 3},
            {"damage", "/field/000002/segments/damage", FieldPlace::segment, 1}}}};
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
  EXPECT_TRUE(is_balanced(xdmf_text("run.h5", sizes, two_steps())));
  EXPECT_TRUE(is_balanced(xdmf_text("run.h5", sizes, {})));
}

TEST(Xdmf, SizesAreThoseOfTheDatasets) {
  const std::string text = xdmf_text("run.h5", sizes, two_steps());
  EXPECT_THAT(text, HasSubstr("Dimensions=\"7 3\">run.h5:/mesh/vertices"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"11\">run.h5:/mesh/mixed"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"2 3\">run.h5:/field/000001/stress"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"7 3\">run.h5:/field/000002/displacement"));
  EXPECT_THAT(text, HasSubstr("Dimensions=\"1\">run.h5:/field/000002/segments/damage"));
  EXPECT_THAT(text, HasSubstr("<Time Value=\"1.5\"/>"));
}

TEST(Xdmf, NormalAndSlidingComponentsAreNamed) {
  const std::string text =
      xdmf_text("run.h5", {2, 7, 11, 4, true},
                {{1, 0.5, {{"opening", "/field/000001/segments/opening", FieldPlace::segment, 3, "n s"}}}});
  EXPECT_TRUE(is_balanced(text));
  EXPECT_THAT(text, HasSubstr("Name=\"opening_n\" AttributeType=\"Scalar\""));
  EXPECT_THAT(text, HasSubstr("Format=\"XML\">0 0 1 1 4 1</DataItem>"));
  EXPECT_THAT(text, HasSubstr("Name=\"opening_s\" AttributeType=\"Scalar\""));
  EXPECT_THAT(text, HasSubstr("Format=\"XML\">0 1 1 1 4 1</DataItem>"));
  EXPECT_THAT(text, Not(HasSubstr("\"Vector\"")));
}

TEST(Xdmf, NoInterfaceGridWithoutSegments) {
  ResultsFile::Sizes blocks_only = sizes;
  blocks_only.segments = 0;
  EXPECT_THAT(xdmf_text("run.h5", blocks_only, two_steps()), Not(HasSubstr("interfaces")));
}

TEST(Xdmf, NamesAreEscaped) {
  const std::string text = xdmf_text("a&b.h5", sizes, {{1, 1, {{"<\"x\">", "/f", FieldPlace::block, 1}}}});
  EXPECT_THAT(text, HasSubstr("a&amp;b.h5:/f"));
  EXPECT_THAT(text, HasSubstr("&lt;&quot;x&quot;>"));
}

}  // namespace
}  // namespace dda
