#include <gmock/gmock.h>

#include <cmath>
#include <regex>

#include "framework/figure/colour_map.hpp"
#include "framework/figure/drawing.hpp"
#include "framework/figure/style.hpp"

namespace dda::svg {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Drawing two_blocks() {
  Drawing drawing;
  drawing.polygons = {{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, {{{2, 0}, {4, 0}, {4, 1}, {2, 1}}}};
  drawing.strokes = {{{2, 0}, {2, 1}, -3, 2}, {{0, 0}, {2, 0}, 5, 2}};
  drawing.stroke_label = "opening [mm]";
  return drawing;
}

/// Corners of the first polygon on the picture.
std::vector<Vec2> first_polygon(const std::string& svg) {
  std::smatch path;
  std::regex_search(svg, path, std::regex("<path d=\"(M[^\"Z]*)Z"));
  const std::string data = path[1];
  const std::regex pair("[ML]([-0-9.]+) ([-0-9.]+)");
  std::vector<Vec2> corners;
  for (std::sregex_iterator it(data.begin(), data.end(), pair), end; it != end; ++it) {
    corners.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  }
  return corners;
}

TEST(Drawing, KeepsTheAspectAndPointsUp) {
  const std::vector<Vec2> corners = first_polygon(to_svg(two_blocks()));
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_NEAR((corners[1] - corners[0]).norm(), 2 * (corners[2] - corners[1]).norm(), 0.05);
  EXPECT_GT(corners[0].y(), corners[3].y()) << "larger y is higher on the picture";
}

TEST(Drawing, ColoursFollowTheValues) {
  const std::string svg = to_svg(two_blocks());
  EXPECT_THAT(svg, HasSubstr("stroke=\"" + colour(ColourMap::crack, 0) + "\" stroke-width=\"2\""));
  EXPECT_THAT(svg, HasSubstr("stroke=\"" + colour(ColourMap::crack, 1) + "\" stroke-width=\"2\""));
  EXPECT_THAT(svg, HasSubstr("opening [mm]"));
}

TEST(Drawing, NoLabelNoColourBar) {
  Drawing drawing = two_blocks();
  drawing.stroke_label = "";
  const std::string svg = to_svg(drawing);
  EXPECT_THAT(svg, HasSubstr("#eeeeee"));
  EXPECT_THAT(svg, HasSubstr("#8b0000"));
  EXPECT_THAT(svg, Not(HasSubstr(colour(ColourMap::crack, 0))));
}

TEST(Drawing, StrangeInputStillGivesAPicture) {
  Drawing drawing = two_blocks();
  drawing.strokes[0].value = std::nan("");
  drawing.strokes.push_back({{std::nan(""), 0}, {1, 1}, 1, 2});
  drawing.polygons.push_back({{{std::nan(""), 0}, {1, 1}, {0, 1}}});
  drawing.polygons.push_back({});
  EXPECT_THAT(to_svg(drawing), Not(HasSubstr("nan")));
  EXPECT_THAT(to_svg(Drawing{}), HasSubstr("nothing to draw"));
  Drawing point;
  point.polygons = {{{{1, 1}, {1, 1}, {1, 1}}}};
  EXPECT_THAT(to_svg(point), Not(HasSubstr("nan")));
}

TEST(ColourMap, EndsAndLimits) {
  EXPECT_EQ(colour(ColourMap::viridis, 0), "#440154");
  EXPECT_EQ(colour(ColourMap::viridis, 1), "#fde725");
  EXPECT_EQ(colour(ColourMap::viridis, 7), "#fde725");
  EXPECT_EQ(colour(ColourMap::viridis, -7), "#440154");
  EXPECT_EQ(colour(ColourMap::viridis, std::nan("")), "#d9d9d9");
}

TEST(Drawing, TintsAndPaletteColours) {
  Drawing drawing = two_blocks();
  drawing.polygons[1].tint = 1;
  drawing.strokes[0].colour = 2;
  const std::string svg = to_svg(drawing);
  EXPECT_THAT(svg, HasSubstr(block_fill));
  EXPECT_THAT(svg, HasSubstr(tints[1]));
  EXPECT_THAT(svg, HasSubstr(std::string("stroke=\"") + palette[2]));
}

/// Numbers of the first element whose text begins so.
std::vector<double> numbers_of(const std::string& svg, const std::string& begin) {
  const std::size_t at = svg.find(begin);
  EXPECT_NE(at, std::string::npos) << begin;
  const std::string element = svg.substr(at, svg.find('>', at) - at);
  std::vector<double> out;
  const std::regex number("\"(-?[0-9.]+)\"");
  for (std::sregex_iterator it(element.begin(), element.end(), number), end; it != end; ++it)
    out.push_back(std::stod((*it)[1]));
  return out;
}

TEST(Drawing, ForcesThatPressEndWhereTheyActAndThoseThatPullBeginThere) {
  Drawing drawing = two_blocks();
  drawing.strokes.clear();
  drawing.symbols = {{.mark = Mark::force, .at = {2, 1}, .along = {0, -5}}};
  const double top = first_polygon(to_svg(drawing))[2].y();
  std::vector<double> shaft = numbers_of(to_svg(drawing), "<line");
  ASSERT_GE(shaft.size(), 4u);
  EXPECT_LT(shaft[1], shaft[3]) << "downwards";
  EXPECT_LE(shaft[3], top);
  drawing.symbols[0].along = {0, 5};
  shaft = numbers_of(to_svg(drawing), "<line");
  EXPECT_NEAR(shaft[1], top, 0.02);
  EXPECT_LT(shaft[3], top);
}

TEST(Drawing, SymbolsThatWouldCoverEachOtherAreDrawnOnceAndNamedOnce) {
  Drawing drawing = two_blocks();
  for (int i = 0; i <= 1000; ++i)
    drawing.symbols.push_back({.mark = Mark::held, .at = {0.004 * i, 0}, .along = {0, 1}, .name = "foot"});
  drawing.key = {{KeyEntry::Kind::held, 0, "held"}};
  const std::string svg = to_svg(drawing);
  const auto count = [&](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(text); at != std::string::npos; at = svg.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count(">foot<"), 1u);
  EXPECT_EQ(count(">held<"), 1u);
  EXPECT_LT(count("fill=\"#ffffff\""), 100u);
  EXPECT_GT(count("fill=\"#ffffff\""), 20u);
}

TEST(Drawing, MarksOfOneKindAtOnePlaceAreOneWithAllNames) {
  Drawing drawing = two_blocks();
  for (const char* name : {"tip", "tip again", "tip", "third"})
    drawing.symbols.push_back({.mark = Mark::measured, .at = {2, 1}, .along = {0, -1}, .name = name});
  EXPECT_THAT(to_svg(drawing), HasSubstr(">tip, tip again, third<"));
  for (const char* name : {"fourth", "fifth"})
    drawing.symbols.push_back({.mark = Mark::measured, .at = {2, 1}, .along = {0, -1}, .name = name});
  EXPECT_THAT(to_svg(drawing), HasSubstr(">tip, tip again, third and 2 more<"));
}

/// Where the dot of what is measured upwards at (2, 1) stands beside other marks there, in x.
double dot_beside(std::vector<Symbol> others) {
  Drawing drawing = two_blocks();
  drawing.strokes.clear();
  drawing.symbols = std::move(others);
  drawing.symbols.push_back({.mark = Mark::measured, .at = {2, 1}, .along = {0, 1}});
  return numbers_of(to_svg(drawing), "<circle")[0];
}

TEST(Drawing, MarksThatWouldCoverEachOtherStandSideBySide) {
  const double alone = dot_beside({});
  constexpr double least = 6;
  EXPECT_GT(std::abs(dot_beside({{.mark = Mark::force, .at = {2, 1}, .along = {0, 5}}}) - alone), least)
      << "a pull";
  EXPECT_GT(std::abs(dot_beside({{.mark = Mark::moved, .at = {2, 1}, .along = {0, 1}}}) - alone), least)
      << "moved";
  EXPECT_EQ(dot_beside({{.mark = Mark::force, .at = {2, 1}, .along = {5, 0}}}), alone)
      << "they meet at right angles";
  EXPECT_EQ(dot_beside({{.mark = Mark::force, .at = {0, 1}, .along = {0, 5}}}), alone) << "elsewhere";
}

TEST(Drawing, HeldBlocksAreHatched) {
  Drawing drawing = two_blocks();
  EXPECT_THAT(to_svg(drawing), Not(HasSubstr("<pattern")));
  drawing.polygons[0].is_held = true;
  EXPECT_THAT(to_svg(drawing), HasSubstr("<pattern"));
}

TEST(Drawing, EveryMarkIsDrawnAndNamedInTheColourAskedFor) {
  for (const Mark mark :
       {Mark::force, Mark::held, Mark::moved, Mark::measured, Mark::turned, Mark::strained}) {
    Drawing drawing = two_blocks();
    drawing.symbols = {{.mark = mark, .at = {1, 0.5}, .along = {1, 1}, .colour = 4, .name = "mark"}};
    const std::string svg = to_svg(drawing);
    EXPECT_THAT(svg, HasSubstr(std::string("stroke=\"") + palette[4]));
    EXPECT_THAT(svg, HasSubstr(">mark<"));
  }
}

}  // namespace
}  // namespace dda::svg
