#include "framework/figure/symbols.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "framework/figure/footprint.hpp"
#include "framework/figure/placement.hpp"

namespace dda::svg {
namespace {

// All lengths in pixels.
constexpr double shortest_arrow = 16, longest_arrow = 46, head = 7, triangle = 9, dot = 3, tail = 16;
constexpr double moving_arrow = 34, bow = 8, half_of_strain = 14;
constexpr double apart = 11;  ///< of symbols of one kind that are both painted
constexpr double slim = 2.7,
                 broad = 4;       ///< half the breadth of an arrow, whose neighbour has room within `apart`
constexpr double text_size = 10;  ///< of names
static_assert(longest_arrow < symbol_reach);

std::string colour_of(int place) { return palette[static_cast<std::size_t>(place) % palette.size()]; }

std::string triangle_at(const Vec2& tip, const Vec2& towards, double length) {
  const Vec2 back = tip - length * towards, beside = 0.45 * length * Vec2(-towards.y(), towards.x());
  std::string out;
  for (const Vec2& corner : {tip, Vec2(back + beside), Vec2(back - beside)})
    out += (out.empty() ? "M" : "L") + coordinate(corner.x()) + " " + coordinate(corner.y());
  return out + "Z";
}

/// A way on the picture.
struct Way {
  Vec2 from, to;
  Vec2 direction() const { return (to - from).normalized(); }
};

void paint_arrow(Canvas& canvas, const Way& way, const std::string& colour, bool is_open = false) {
  const Vec2 neck = way.to - (is_open ? 1.0 : 0.8) * head * way.direction();
  canvas.line({way.from.x(), way.from.y(), neck.x(), neck.y()}, {colour, is_open ? 1.5 : 2});
  canvas.path(triangle_at(way.to, way.direction(), head), is_open ? paper : colour,
              {colour, is_open ? 1.3 : 0.5});
}

void paint_held(Canvas& canvas, const Vec2& at, const Vec2& inward, const std::string& colour) {
  canvas.path(triangle_at(at, inward, triangle), paper, {colour, 1.3});
}

void paint_measured(Canvas& canvas, const Way& way, const std::string& colour) {
  canvas.line({way.from.x(), way.from.y(), way.to.x(), way.to.y()}, {colour, 1.5});
  canvas.circle(way.from.x(), way.from.y(), dot);
}

/// Three quarters of a circle, counter-clockwise.
void paint_turn(Canvas& canvas, const Vec2& at, const std::string& colour) {
  const std::string radius = coordinate(bow);
  canvas.path("M" + coordinate(at.x() + bow) + " " + coordinate(at.y()) + "A" + radius + " " + radius +
                  " 0 1 0 " + coordinate(at.x()) + " " + coordinate(at.y() + bow),
              "none", {colour, 1.5});
  canvas.path(triangle_at(at + Vec2(head, bow), {1, 0}, head), colour, {colour, 0.5});
  canvas.circle(at.x(), at.y(), dot);
}

void paint_strain(Canvas& canvas, const Vec2& at, const Vec2& along, const std::string& colour) {
  for (const double way : {-1.0, 1.0}) paint_arrow(canvas, {at, at + way * half_of_strain * along}, colour);
}

/// A symbol on the picture, y downwards, with the names of those that it stands for.
struct Placed {
  const Symbol* symbol;
  Vec2 at, direction;  ///< of unit length
  double size;         ///< of a force
  std::vector<std::string> names = {};

  void take_name(const std::string& name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  bool resembles(const Placed& other) const {
    return symbol->mark == other.symbol->mark && symbol->colour == other.symbol->colour &&
           direction.dot(other.direction) > 0.99 && (at - other.at).norm() < apart;
  }
};

class SymbolPainter {
 public:
  SymbolPainter(Canvas& canvas, const View& view, const std::vector<Symbol>& symbols)
      : canvas_(canvas), names_(around(view.frame()), {}) {
    const Box& frame = view.frame();
    centre_ = {frame.x + frame.width / 2, frame.y + frame.height / 2};
    for (const Symbol& symbol : symbols) {
      const Vec2 on_picture(symbol.along.x(), -symbol.along.y());
      const double size = on_picture.norm();
      if (!(size > 0) || !symbol.at.allFinite()) continue;
      const Placed placed{&symbol, view.pixel(symbol.at), on_picture / size, size};
      const auto before = std::ranges::find_if(placed_, [&](const Placed& p) { return p.resembles(placed); });
      Placed& painted = before == placed_.end() ? placed_.emplace_back(placed) : *before;
      painted.take_name(symbol.name);
      if (double& largest = largest_[symbol.colour]; symbol.mark == Mark::force)
        largest = std::max(largest, painted.size);
    }
  }

  void paint() {
    Footprints taken;
    for (Placed& placed : placed_) {
      placed.at += taken.shift_of(footprint(placed), placed.direction);
      taken.add(footprint(placed));
    }
    for (const Placed& placed : placed_) paint(placed);
    for (const Placed& placed : placed_) write_names(placed);
  }

 private:
  /// Where names may stand.
  static Box around(const Box& frame) {
    return {frame.x - symbol_reach, frame.y - symbol_reach, frame.width + 2 * symbol_reach,
            frame.height + 2 * symbol_reach};
  }

  /// Whether a direction leads away from the middle of the picture.
  bool is_outward(const Placed& placed) const { return placed.direction.dot(placed.at - centre_) > 0; }

  /// From where to where it is painted, without its breadth.
  Way way_of(const Placed& placed) const {
    const auto& [symbol, at, direction, size, names] = placed;
    switch (symbol->mark) {
      case Mark::force:
        return way_of_force(placed);
      case Mark::held:
        return {at, at - triangle * inward(placed)};
      case Mark::moved:
        return {at, at + moving_arrow * direction};
      case Mark::measured:
        return {at, at + tail * direction};
      case Mark::turned:
        return {at, at};
      case Mark::strained:
        return {at - half_of_strain * direction, at + half_of_strain * direction};
    }
    return {at, at};
  }

  /// What pulls begins where it acts, what presses ends there.
  Way way_of_force(const Placed& placed) const {
    const double length =
        shortest_arrow + (longest_arrow - shortest_arrow) * placed.size / largest_.at(placed.symbol->colour);
    const Vec2 way = length * placed.direction;
    const Vec2 start = is_outward(placed) ? placed.at : Vec2(placed.at - way);
    return {start, start + way};
  }

  Vec2 inward(const Placed& placed) const {
    return is_outward(placed) ? Vec2(-placed.direction) : placed.direction;
  }

  Footprint footprint(const Placed& placed) const {
    const Way way = way_of(placed);
    const Mark mark = placed.symbol->mark;
    return {way.from, way.to, placed.at, mark == Mark::turned ? bow : mark == Mark::force ? slim : broad};
  }

  void paint(const Placed& placed) {
    const std::string colour = colour_of(placed.symbol->colour);
    const Way way = way_of(placed);
    const Vec2 breadth = placed.symbol->mark == Mark::turned ? Vec2(bow, bow) : Vec2::Zero();
    keep_free(way.from - breadth, way.to + breadth);
    switch (placed.symbol->mark) {
      case Mark::force:
        return paint_arrow(canvas_, way, colour);
      case Mark::held:
        return paint_held(canvas_, placed.at, inward(placed), colour);
      case Mark::moved:
        return paint_arrow(canvas_, way, colour, true);
      case Mark::measured:
        return paint_measured(canvas_, way, colour);
      case Mark::turned:
        return paint_turn(canvas_, placed.at, colour);
      case Mark::strained:
        return paint_strain(canvas_, placed.at, placed.direction, colour);
    }
  }

  void keep_free(const Vec2& a, const Vec2& b) {
    constexpr double beside = 3;
    const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);
    names_.keep_free({low.x() - beside, low.y() - beside, high.x() - low.x() + 2 * beside,
                      high.y() - low.y() + 2 * beside});
  }

  /// Those that are not written yet, as one text.
  void write_names(const Placed& placed) {
    constexpr std::size_t most = 3;
    std::vector<std::string> names;
    for (const std::string& name : placed.names)
      if (written_.insert(name).second) names.push_back(name);
    if (names.empty()) return;
    const std::size_t told = std::min(most, names.size());
    std::string text =
        fmt::format("{}", fmt::join(names.begin(), names.begin() + std::ptrdiff_t(told), ", "));
    if (names.size() > told) text += fmt::format(" and {} more", names.size() - told);
    const Box box = names_.place(placed.at.x(), placed.at.y(), text_width(text, text_size), text_size + 2);
    canvas_.text(box.x, box.bottom() - 2, text, {.size = text_size, .halo = true});
  }

  Canvas& canvas_;
  LabelPlacer names_;
  Vec2 centre_ = Vec2::Zero();
  std::vector<Placed> placed_;
  std::map<int, double> largest_;  ///< force of each colour
  std::set<std::string> written_;
};

constexpr double swatch = 22;  ///< breadth of a sign of the legend [px]

/// The sign of a line of the legend, whose left end is at `left`.
void paint_sign(Canvas& canvas, const KeyEntry& entry, const Vec2& left) {
  const std::string colour = colour_of(entry.colour);
  const Vec2 right = left + Vec2(swatch, 0), middle = (left + right) / 2;
  const Box box{left.x(), left.y() - 6, swatch, 12};
  switch (entry.kind) {
    case KeyEntry::Kind::fill:
      return canvas.rectangle(
          box, entry.colour < 0 ? block_fill : tints[static_cast<std::size_t>(entry.colour) % tints.size()],
          block_edge);
    case KeyEntry::Kind::hatching:
      canvas.rectangle(box, "none", block_edge);
      return canvas.hatch("M" + coordinate(box.x) + " " + coordinate(box.y) + "h" + coordinate(box.width) +
                          "v" + coordinate(box.height) + "h" + coordinate(-box.width) + "Z");
    case KeyEntry::Kind::line:
      return canvas.line({left.x(), left.y(), right.x(), right.y()}, {colour, 2.5});
    case KeyEntry::Kind::force:
      return paint_arrow(canvas, {left, right}, colour);
    case KeyEntry::Kind::moved:
      return paint_arrow(canvas, {left, right}, colour, true);
    case KeyEntry::Kind::held:
      return paint_held(canvas, middle - Vec2(0, triangle / 2), {0, -1}, colour);
    case KeyEntry::Kind::measured:
      return paint_measured(canvas, {left + Vec2(dot, 0), right}, colour);
    case KeyEntry::Kind::turned:
      return paint_turn(canvas, middle, colour);
    case KeyEntry::Kind::strained:
      return paint_strain(canvas, middle, {1, 0}, colour);
  }
}

}  // namespace

void paint_symbols(Canvas& canvas, const View& view, const std::vector<Symbol>& symbols) {
  SymbolPainter(canvas, view, symbols).paint();
}

double paint_key(Canvas& canvas, const std::vector<KeyEntry>& key, const Vec2& corner) {
  constexpr double size = 11;
  double widest = 0, y = corner.y() + key_line / 2;
  for (const KeyEntry& entry : key) {
    paint_sign(canvas, entry, {corner.x(), y});
    const double text = swatch + 8;
    canvas.text(corner.x() + text, y + 4, entry.name, {size});
    widest = std::max(widest, text + text_width(entry.name, size));
    y += key_line;
  }
  return widest;
}

}  // namespace dda::svg
