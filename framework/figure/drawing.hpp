#pragma once

#include <string>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda::svg {

/// A polygon filled by the colour of its value; NaN is drawn light grey.
struct Fill {
  std::vector<Vec2> outline;
  double value = 0;
  bool is_marked = false;  ///< gets a red outline, above everything
};

/// A segment coloured by its value; width in points.
struct Stroke {
  Vec2 start, end;
  double value = 0;
  double width = 1.5;
};

/// A short text centred at a place.
struct Note {
  Vec2 at;
  std::string text;
};

/// A plane picture at equal scale in x and y: filled polygons below, coloured segments above.
/// An empty label means no colour bar: polygons are then pale grey, strokes dark red.
struct Drawing {
  std::string title, caption;
  std::vector<Fill> polygons;
  std::string polygon_label;  ///< quantity and unit, such as "σ_xx [MPa]"
  std::vector<Stroke> strokes;
  std::string stroke_label;
  std::vector<Note> notes = {};
  double width = 680, height = 460;  ///< room for the picture [px]
};

/// The drawing as a self-contained SVG text on white: polygons in viridis, strokes from dark red to yellow.
std::string to_svg(const Drawing& drawing);

}  // namespace dda::svg
