#include "framework/figure/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "framework/figure/axis.hpp"
#include "framework/figure/canvas.hpp"
#include "framework/figure/colour_map.hpp"
#include "framework/figure/symbols.hpp"
#include "framework/figure/view.hpp"

namespace dda::svg {
namespace {

constexpr double bar_width = 14;

/// Values of strokes and what they look like.
struct Scale {
  Range range;
  std::string label;

  bool shown() const { return !label.empty() && !range.empty; }
  std::string colour_of(double value) const {
    const Range wide = range.widened(0);
    return colour(ColourMap::crack, (value - wide.low) / (wide.high - wide.low));
  }
};

View view_of(const Drawing& drawing) {
  Range x, y;
  const auto include = [&](const Vec2& point) {
    x.include(point.x());
    y.include(point.y());
  };
  for (const Fill& fill : drawing.polygons) std::for_each(fill.outline.begin(), fill.outline.end(), include);
  for (const Stroke& stroke : drawing.strokes) {
    include(stroke.start);
    include(stroke.end);
  }
  for (const Note& note : drawing.notes) include(note.at);
  View out(x, y, drawing.width, drawing.height);
  if (!drawing.symbols.empty()) out.move_by(symbol_reach, symbol_reach);
  return out;
}

Scale scale_of(const Drawing& drawing) {
  Range range;
  for (const Stroke& stroke : drawing.strokes)
    if (stroke.colour < 0) range.include(stroke.value);
  return {range, drawing.stroke_label};
}

bool finite(const Vec2& point) { return point.allFinite(); }

/// An outline as a path; "" where there is none to draw.
std::string path_of(const View& view, const Fill& fill) {
  if (fill.outline.empty() || !std::all_of(fill.outline.begin(), fill.outline.end(), finite)) return {};
  std::string data;
  for (const Vec2& vertex : fill.outline) data += (data.empty() ? "M" : "L") + view.place(vertex);
  return data + 'Z';
}

/// All polygons of one tint are one path, and all that are held.
void paint_polygons(Canvas& canvas, const View& view, const Drawing& drawing) {
  std::map<int, std::string> by_tint;
  for (const Fill& fill : drawing.polygons) by_tint[fill.tint] += path_of(view, fill);
  for (const auto& [tint, all] : by_tint)
    canvas.path(all, tint < 0 ? block_fill : tints[static_cast<std::size_t>(tint) % tints.size()],
                {block_edge, 0.4});
  std::string held;
  for (const Fill& fill : drawing.polygons)
    if (fill.is_held) held += path_of(view, fill);
  canvas.hatch(held);
}

void paint_marks(Canvas& canvas, const View& view, const Drawing& drawing) {
  for (const Fill& fill : drawing.polygons)
    if (fill.is_marked) canvas.path(path_of(view, fill), "none", {mark_outline, 2});
}

/// All strokes of one colour of the palette and one width are one path.
void paint_strokes(Canvas& canvas, const View& view, const Drawing& drawing, const Scale& scale) {
  std::map<std::pair<int, double>, std::string> of_palette;
  for (const Stroke& stroke : drawing.strokes) {
    if (!finite(stroke.start) || !finite(stroke.end)) continue;
    const std::string track = "M" + view.place(stroke.start) + "L" + view.place(stroke.end);
    if (stroke.colour >= 0)
      of_palette[{stroke.colour, stroke.width}] += track;
    else
      canvas.path(track, "none", {scale.shown() ? scale.colour_of(stroke.value) : "#8b0000", stroke.width});
  }
  for (const auto& [style, tracks] : of_palette)
    canvas.path(tracks, "none",
                {palette[static_cast<std::size_t>(style.first) % palette.size()], style.second});
}

/// A vertical colour bar at the left edge of `room`; gives the width used.
double paint_bar(Canvas& canvas, const Scale& scale, const Box& room) {
  const Axis axis = make_axis(scale.range.widened(0), 5);
  const double height = room.height / colour_steps;
  for (int i = 0; i < colour_steps; ++i) {
    // Each slice reaches a little under the one above, against hairlines.
    const Box slice{room.x, room.bottom() - (i + 1) * height, bar_width, height + (i == 0 ? 0 : 0.6)};
    canvas.rectangle(slice, colour(ColourMap::crack, (i + 0.5) / colour_steps), "none");
  }
  canvas.rectangle({room.x, room.y, bar_width, room.height}, "none", ink);
  double widest = 0;
  for (const Tick& tick : axis.ticks) {
    const double y =
        room.bottom() - room.height * ((tick.value - axis.range.low) / (axis.range.high - axis.range.low));
    canvas.line({room.x + bar_width, y, room.x + bar_width + 4, y}, {ink, 1});
    canvas.text(room.x + bar_width + 7, y + 3.5, tick.label, {small_text});
    widest = std::max(widest, text_width(tick.label, small_text));
  }
  canvas.text(room.x, room.y - 8, axis.scale, {small_text});
  const double x = room.x + bar_width + 7 + widest + normal_text + 4;
  canvas.text(x, room.y + room.height / 2, fitted(scale.label, normal_text, room.height),
              {normal_text, Anchor::middle, false, -90});
  return std::max(x + 8 - room.x, text_width(axis.scale, small_text));
}

/// Breaks a text into lines at spaces.
std::vector<std::string> lines_of(const std::string& text, double room) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!lines.back().empty() && text_width(lines.back() + " " + word, normal_text) > room)
      lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return lines;
}

double paint_caption(Canvas& canvas, const std::string& caption, const Box& room) {
  if (caption.empty()) return 0;
  double y = room.y;
  for (const std::string& line : lines_of(caption, room.width)) {
    y += normal_text + 5;
    canvas.text(room.x, y, fitted(line, normal_text, room.width), {normal_text});
  }
  return y - room.y;
}

}  // namespace

std::string to_svg(const Drawing& drawing) {
  Canvas canvas;
  View view = view_of(drawing);
  const Scale scale = scale_of(drawing);
  view.move_by(0, (drawing.title.empty() ? 0 : large_text + 10) + (scale.shown() ? 14 : 0) +
                      (drawing.notes.empty() ? 0 : 2 * small_text));
  const Box& frame = view.frame();
  const double reach = drawing.symbols.empty() ? 0 : symbol_reach;
  double right = frame.right() + reach;
  if (scale.shown()) right += 20 + paint_bar(canvas, scale, {right + 20, frame.y, 0, frame.height});
  if (!drawing.key.empty()) right += 12 + paint_key(canvas, drawing.key, {right + 12, frame.y});
  right = std::max(right, drawing_margin + std::min(text_width(drawing.title, large_text), drawing.width));
  canvas.text(drawing_margin, drawing_margin + large_text,
              fitted(drawing.title, large_text, right - drawing_margin), {large_text, Anchor::start, true});
  paint_polygons(canvas, view, drawing);
  paint_strokes(canvas, view, drawing, scale);
  paint_marks(canvas, view, drawing);
  paint_symbols(canvas, view, drawing.symbols);
  for (const Note& note : drawing.notes)
    canvas.text(view.across(note.at), view.down(note.at), note.text, {small_text, Anchor::middle});
  if (drawing.polygons.empty() && drawing.strokes.empty()) {
    canvas.text(frame.x + frame.width / 2, frame.y + frame.height / 2, "nothing to draw",
                {normal_text, Anchor::middle});
  }
  const double bottom =
      std::max(frame.bottom() + reach, frame.y + key_line * static_cast<double>(drawing.key.size()));
  const double caption =
      paint_caption(canvas, drawing.caption, {drawing_margin, bottom + 8, right - drawing_margin, 0});
  return canvas.document(right + drawing_margin, bottom + 8 + caption + drawing_margin);
}

}  // namespace dda::svg
