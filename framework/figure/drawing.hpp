#pragma once

#include <string>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda::svg {

/// A polygon in pale grey, or in one of the tints (style.hpp).
struct Fill {
  std::vector<Vec2> outline = {};
  bool is_marked = false;  ///< gets a red outline, above everything
  int tint = -1;           ///< place among the tints
  bool is_held = false;    ///< gets a hatching
};

/// A segment coloured by its value, or in a colour of the palette; NaN is drawn light grey. Width in points.
struct Stroke {
  Vec2 start, end;
  double value = 0;
  double width = 1.5;
  int colour = -1;  ///< place in the palette
};

/// What stands at a place: a force (an arrow whose length tells its size), what is held along a direction (a
/// triangle), what moves along one (an arrow with an open head), what is measured along one (a dot with a tail),
/// turns (a bow around a dot) or is strained along a direction (an arrow with two heads).
enum class Mark { force, held, moved, measured, turned, strained };

struct Symbol {
  Mark mark = Mark::force;
  Vec2 at = Vec2::Zero();
  Vec2 along =
      Vec2::Zero();       ///< direction, and of a force its size, in any unit; of what turns of no meaning
  int colour = 0;         ///< place in the palette
  std::string name = {};  ///< beside the first of that name; "" for none
};

/// A line of the legend: the colour of a tint, or of the palette; a hatching has none.
struct KeyEntry {
  enum class Kind { fill, line, hatching, force, held, moved, measured, turned, strained };
  Kind kind = Kind::fill;
  int colour = 0;
  std::string name = {};
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
  std::vector<Symbol> symbols = {};
  std::vector<KeyEntry> key = {};    ///< legend, right of the picture
  double width = 680, height = 460;  ///< room for the picture [px]
};

/// The drawing as a self-contained SVG text on white, strokes from dark red to yellow.
std::string to_svg(const Drawing& drawing);

}  // namespace dda::svg
