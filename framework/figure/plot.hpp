#pragma once

#include <string>
#include <vector>

namespace dda::svg {

/// A curve drawn through its points in the order given, so that a snap-back turns back.
/// Points that are not finite interrupt the line. colour: number in the palette, −1 = next one. A series
/// without points stands in the legend alone.
struct Series {
  std::string name = {};  ///< legend; "" = none
  std::vector<double> x = {}, y = {};
  bool dashed = false;
  int colour = -1;
  bool dotted = false;
};

/// One marked point, such as the limit point.
struct Marker {
  double x = 0, y = 0;
  std::string label;
};

/// One pair of axes. Labels include their unit: "deflection [mm]". On a logarithmic one points that are not positive are not
/// drawn.
struct Panel {
  std::string title = {};
  std::string x_label = {}, y_label = {};
  std::vector<Series> series = {};
  std::vector<Marker> markers = {};
  bool is_logarithmic_x = false, is_logarithmic_y = false;
};

/// Several panels side by side, at most three in a row; series of one name share a colour and one legend.
struct Figure {
  std::string title = {};
  std::vector<Panel> panels = {};
};

/// The figure as a self-contained SVG text on white, in the colour-blind-safe palette.
std::string to_svg(const Figure& figure);

}  // namespace dda::svg
