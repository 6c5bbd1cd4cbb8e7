#pragma once

#include <string>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda::svg {

/// A polygon in pale grey.
struct Fill {
  std::vector<Vec2> outline = {};
  bool is_marked = false;  ///< gets a red outline, above everything
};

/// A segment coloured by its value; NaN is drawn light grey. Width in points.
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
/// Without a label there is no colour bar, and strokes are dark red.
struct Drawing {
  std::string title = {}, caption = {};
  std::vector<Fill> polygons = {};
  std::vector<Stroke> strokes = {};
  std::string stroke_label = {};  ///< quantity and unit, such as "opening [mm]"
  std::vector<Note> notes = {};
  double width = 680, height = 460;  ///< room for the picture [px]
};

/// The drawing as a self-contained SVG text on white, strokes from dark red to yellow.
std::string to_svg(const Drawing& drawing);

}  // namespace dda::svg
