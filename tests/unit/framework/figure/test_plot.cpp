#include <gmock/gmock.h>

#include <cmath>
#include <regex>

#include "framework/figure/plot.hpp"

namespace dda::svg {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Panel snap_back() {
  return {"Midspan",
          "deflection [mm]",
          "load [N]",
          {{"dissipation", {0, 0.05, 0.03}, {0, 3400, 1000}, false, -1}},
          {{0.05, 3400, "limit point"}}};
}

std::size_t count(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), expression), {}));
}

/// The x coordinates of the first curve.
std::vector<double> curve_x(const std::string& svg) {
  std::smatch path;
  std::regex_search(svg, path, std::regex("<path d=\"([^\"]*)\""));
  const std::string data = path[1];
  const std::regex pair("[ML]([-0-9.]+) ");
  std::vector<double> x;
  for (std::sregex_iterator it(data.begin(), data.end(), pair), end; it != end; ++it)
    x.push_back(std::stod((*it)[1]));
  return x;
}

/// Every coordinate of lines, texts and boxes lies on the picture.
void expect_inside(const std::string& svg) {
  std::smatch size;
  ASSERT_TRUE(std::regex_search(svg, size, std::regex("width=\"([0-9.]+)\" height=\"([0-9.]+)\"")));
  const std::regex place(" (x|y|cx|cy|x1|y1|x2|y2)=\"([-0-9.naif]+)\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), place), end; it != end; ++it) {
    const double limit = std::stod((*it)[1].str().find('x') != std::string::npos ? size[1] : size[2]);
    const double value = std::stod((*it)[2]);
    EXPECT_TRUE(value >= 0 && value <= limit) << it->str();
  }
}

TEST(Plot, SnapBackTurnsBack) {
  const std::vector<double> x = curve_x(to_svg(Figure{"", {snap_back()}}));
  ASSERT_EQ(x.size(), 3u);
  EXPECT_LT(x[0], x[2]);
  EXPECT_LT(x[2], x[1]);
}

TEST(Plot, HasLabelsLegendAndMarker) {
  const std::string svg = to_svg(Figure{"Beam & more", {snap_back()}});
  for (const char* text :
       {"Beam &amp; more", "Midspan", "deflection [mm]", "load [N]", ">dissipation<", "limit point"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_EQ(count(svg, "<circle"), 1u);
}

TEST(Plot, OneNameOneColourOneLegendEntry) {
  const std::string svg = to_svg(Figure{"", {snap_back(), snap_back(), snap_back()}});
  EXPECT_EQ(count(svg, ">dissipation<"), 1u);
  EXPECT_EQ(count(svg, "<path[^>]*stroke=\"#0072B2\""), 3u);
}

TEST(Plot, DashedSeriesAreDashed) {
  Panel panel = snap_back();
  EXPECT_THAT(to_svg(Figure{"", {panel}}), Not(HasSubstr("stroke-dasharray")));
  panel.series[0].dashed = true;
  EXPECT_THAT(to_svg(Figure{"", {panel}}), HasSubstr("stroke-dasharray"));
}

TEST(Plot, AGapInTheNumbersIsAGapInTheLine) {
  Panel panel;
  panel.series = {{"", {0, 1, 2, 3, 4}, {0, 1, std::nan(""), 1, 0}, false, -1}};
  EXPECT_EQ(count(to_svg(Figure{"", {panel}}), "<path"), 2u);
}

TEST(Plot, EverythingIsOnThePictureForAnyRange) {
  for (std::size_t panels = 0; panels <= 7; ++panels) {
    Figure figure{"Title", {}};
    for (std::size_t i = 0; i < panels; ++i) {
      Panel panel = snap_back();
      const double factor = std::pow(10.0, 6.0 * static_cast<double>(i) - 15) * (i % 2 == 0 ? 1 : -1);
      for (double& y : panel.series[0].y) y *= factor;
      panel.markers[0].y *= factor;
      figure.panels.push_back(panel);
    }
    expect_inside(to_svg(figure));
  }
}

TEST(Plot, EmptyAndConstantSeriesAreDrawn) {
  Panel constant = snap_back();
  constant.series[0].y = {5, 5, 5};
  constant.markers.clear();
  const std::string svg = to_svg(Figure{"", {Panel{}, constant}});
  EXPECT_THAT(svg, HasSubstr("no data"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  expect_inside(svg);
}

TEST(Plot, EqualFactorsAreEquallyFarOnLogarithmicAxes) {
  Panel panel;
  panel.series = {{"", {-1, 0, 1, 10, 100}, {1, 2, 5, 50, 500}, false, -1}};
  panel.is_logarithmic_x = panel.is_logarithmic_y = true;
  const std::string svg = to_svg(Figure{"", {panel}});
  std::smatch path;
  ASSERT_TRUE(std::regex_search(
      svg, path, std::regex("<path d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)\"")))
      << "what is not positive is left out";
  const auto number = [&](int i) { return std::stod(path[static_cast<std::size_t>(i)]); };
  EXPECT_NEAR(number(3) - number(1), number(5) - number(3), 0.02);
  EXPECT_NEAR(number(2) - number(4), number(4) - number(6), 0.02);
  EXPECT_GT(number(3), number(1) + 50);
  expect_inside(svg);
}

}  // namespace
}  // namespace dda::svg
