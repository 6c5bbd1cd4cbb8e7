#include "framework/figure/symbols.hpp"

#include <array>
#include <cmath>
#include <map>

#include "framework/figure/placement.hpp"

namespace dda::svg {
namespace {

// All lengths in pixels.
constexpr double shortest_arrow = 16, longest_arrow = 46, head = 7, triangle = 9, dot = 3, tail = 16;
constexpr double apart = 11;      ///< of symbols that are both painted
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

/// A symbol on the picture, y downwards.
struct Placed {
  const Symbol* symbol;
  Vec2 at, direction;  ///< of unit length
  double size;         ///< of a force

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
      if (std::ranges::any_of(placed_, [&](const Placed& p) { return p.resembles(placed); })) continue;
      placed_.push_back(placed);
      if (double& largest = largest_[symbol.colour]; symbol.mark == Mark::force)
        largest = std::max(largest, size);
    }
  }

  void paint() {
    for (const Placed& placed : placed_) paint(placed);
    for (const Placed& placed : placed_)
      if (is_first_of_name(placed)) write_name(placed);
  }

 private:
  /// Where names may stand.
  static Box around(const Box& frame) {
    return {frame.x - symbol_reach, frame.y - symbol_reach, frame.width + 2 * symbol_reach,
            frame.height + 2 * symbol_reach};
  }

  /// Whether a direction leads away from the middle of the picture.
  bool is_outward(const Placed& placed) const { return placed.direction.dot(placed.at - centre_) > 0; }

  void paint(const Placed& placed) {
    const std::string colour = colour_of(placed.symbol->colour);
    switch (placed.symbol->mark) {
      case Mark::force:
        return paint_force(placed, colour);
      case Mark::held: {
        const Vec2 inward = is_outward(placed) ? Vec2(-placed.direction) : placed.direction;
        canvas_.path(triangle_at(placed.at, inward, triangle), "#ffffff", {colour, 1.3});
        return keep_free(placed.at, placed.at - triangle * inward);
      }
      case Mark::measured: {
        const Vec2 end = placed.at + tail * placed.direction;
        canvas_.line({placed.at.x(), placed.at.y(), end.x(), end.y()}, {colour, 1.5});
        canvas_.circle(placed.at.x(), placed.at.y(), dot);
        return keep_free(placed.at, end);
      }
    }
  }

  /// What pulls begins where it acts, what presses ends there.
  void paint_force(const Placed& placed, const std::string& colour) {
    const double length =
        shortest_arrow + (longest_arrow - shortest_arrow) * placed.size / largest_.at(placed.symbol->colour);
    const Vec2 way = length * placed.direction;
    const Vec2 start = is_outward(placed) ? placed.at : Vec2(placed.at - way), tip = start + way;
    const Vec2 neck = tip - 0.8 * head * placed.direction;
    canvas_.line({start.x(), start.y(), neck.x(), neck.y()}, {colour, 2});
    canvas_.path(triangle_at(tip, placed.direction, head), colour, {colour, 0.5});
    keep_free(start, tip);
  }

  void keep_free(const Vec2& a, const Vec2& b) {
    constexpr double beside = 3;
    const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);
    names_.keep_free({low.x() - beside, low.y() - beside, high.x() - low.x() + 2 * beside,
                      high.y() - low.y() + 2 * beside});
  }

  bool is_first_of_name(const Placed& placed) const {
    if (placed.symbol->name.empty()) return false;
    const auto first =
        std::ranges::find(placed_, placed.symbol->name, [](const Placed& p) { return p.symbol->name; });
    return &*first == &placed;
  }

  void write_name(const Placed& placed) {
    const std::string& name = placed.symbol->name;
    const Box box = names_.place(placed.at.x(), placed.at.y(), text_width(name, text_size), text_size + 2);
    canvas_.text(box.x, box.bottom() - 2, name, {.size = text_size, .halo = true});
  }

  Canvas& canvas_;
  LabelPlacer names_;
  Vec2 centre_ = Vec2::Zero();
  std::vector<Placed> placed_;
  std::map<int, double> largest_;  ///< force of each colour
};

}  // namespace

void paint_symbols(Canvas& canvas, const View& view, const std::vector<Symbol>& symbols) {
  SymbolPainter(canvas, view, symbols).paint();
}

double paint_key(Canvas& canvas, const std::vector<KeyEntry>& key, const Vec2& corner) {
  constexpr double line = key_line, swatch = 22, size = 11;
  double widest = 0, y = corner.y() + line / 2;
  for (const KeyEntry& entry : key) {
    const std::string colour = colour_of(entry.colour);
    const double left = corner.x(), right = left + swatch;
    switch (entry.kind) {
      case KeyEntry::Kind::fill:
        canvas.rectangle(
            {left, y - 6, swatch, 12},
            entry.colour < 0 ? block_fill : tints[static_cast<std::size_t>(entry.colour) % tints.size()],
            "#a0a0a0");
        break;
      case KeyEntry::Kind::line:
        canvas.line({left, y, right, y}, {colour, 2.5});
        break;
      case KeyEntry::Kind::force:
        canvas.line({left, y, right - head, y}, {colour, 2});
        canvas.path(triangle_at({right, y}, {1, 0}, head), colour, {colour, 0.5});
        break;
      case KeyEntry::Kind::held:
        canvas.path(triangle_at({left + swatch / 2, y - triangle / 2}, {0, -1}, triangle), "#ffffff",
                    {colour, 1.3});
        break;
      case KeyEntry::Kind::measured:
        canvas.circle(left + dot, y, dot);
        canvas.line({left + dot, y, right, y}, {colour, 1.5});
        break;
    }
    canvas.text(right + 8, y + 4, entry.name, {size});
    widest = std::max(widest, swatch + 8 + text_width(entry.name, size));
    y += line;
  }
  return widest;
}

}  // namespace dda::svg
