#pragma once

#include <string>
#include <string_view>

#include "framework/figure/style.hpp"

namespace dda::svg {

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 11;  ///< [px]
  Anchor anchor = Anchor::start;
  bool bold = false;
  double rotate = 0;  ///< [degrees], clockwise
  bool halo = false;  ///< white around it, to be read on lines
};

struct LineStyle {
  std::string colour = ink;
  double width = 1;
  bool dashed = false;
  double dash_offset = 0;  ///< where the dashes start, so that coinciding curves show one after the other
  bool dotted = false;     ///< instead of dashed
};

struct Segment {
  double x1, y1, x2, y2;
};

/// A rectangle of the picture, y downwards [px].
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

/// Room a text takes, estimated from above for common sans-serif fonts [px].
double text_width(std::string_view text, double size);
/// The text, cut with an ellipsis when it is wider than `room`.
std::string fitted(std::string_view text, double size, double room);
/// A coordinate with two decimals.
std::string coordinate(double value);

/// Collects SVG elements; coordinates in px, y downwards.
class Canvas {
 public:
  void line(const Segment& at, const LineStyle& style);
  void rectangle(const Box& box, const std::string& fill, const std::string& stroke);
  void circle(double x, double y, double radius);
  void text(double x, double y, std::string_view text, const TextStyle& style);
  /// `data` in SVG path commands.
  void path(const std::string& data, const std::string& fill, const LineStyle& style);
  /// Hatches the inside of a path.
  void hatch(const std::string& data);
  /// The whole document on white.
  std::string document(double width, double height) const;

 private:
  std::string body_;
};

}  // namespace dda::svg
