#include "framework/figure/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace dda::svg {
namespace {

bool starts_character(char c) { return (c & 0xC0) != 0x80; }

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

const char* name_of(Anchor anchor) {
  if (anchor == Anchor::middle) return "middle";
  return anchor == Anchor::end ? "end" : "start";
}

std::string stroke_of(const LineStyle& style) {
  std::string pattern;
  if (style.dotted)
    pattern = fmt::format(" stroke-dasharray=\"{}\"", fmt::join(dots, " "));
  else if (style.dashed)
    pattern = fmt::format(" stroke-dasharray=\"{}\" stroke-dashoffset=\"{}\"", fmt::join(dashes, " "),
                          coordinate(style.dash_offset));
  return fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", style.colour, coordinate(style.width), pattern);
}

}  // namespace

double text_width(std::string_view text, double size) {
  // Mean advance of DejaVu Sans, the widest of the usual fonts.
  constexpr double em_per_character = 0.61;
  const auto count = std::count_if(text.begin(), text.end(), starts_character);
  return em_per_character * size * static_cast<double>(count);
}

std::string fitted(std::string_view text, double size, double room) {
  if (text_width(text, size) <= room) return std::string(text);
  std::string result;
  for (const char c : text) {
    if (starts_character(c) && text_width(result, size) + 2 * text_width("x", size) > room) break;
    result += c;
  }
  return result + "…";
}

std::string coordinate(double value) {
  std::array<char, 320> buffer;  // the largest number has 309 digits
  const auto end = std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed, 2).ptr;
  std::string text(buffer.begin(), end);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

void Canvas::line(const Segment& at, const LineStyle& style) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", coordinate(at.x1),
                       coordinate(at.y1), coordinate(at.x2), coordinate(at.y2), stroke_of(style));
}

void Canvas::rectangle(const Box& box, const std::string& fill, const std::string& stroke) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n",
                       coordinate(box.x), coordinate(box.y), coordinate(box.width), coordinate(box.height),
                       fill, stroke);
}

void Canvas::circle(double x, double y, double radius) {
  body_ +=
      fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.5\"/>\n",
                  coordinate(x), coordinate(y), coordinate(radius), paper, ink);
}

void Canvas::text(double x, double y, std::string_view text, const TextStyle& style) {
  if (text.empty()) return;
  const std::string turn = style.rotate == 0 ? ""
                                             : fmt::format(" transform=\"rotate({} {} {})\"", style.rotate,
                                                           coordinate(x), coordinate(y));
  const std::string halo =
      style.halo
          ? fmt::format(" paint-order=\"stroke\" stroke=\"{}\" stroke-width=\"3\" stroke-linejoin=\"round\"",
                        paper)
          : "";
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"{}{}{}>{}</text>\n",
                       coordinate(x), coordinate(y), coordinate(style.size), name_of(style.anchor),
                       style.bold ? " font-weight=\"bold\"" : "", halo, turn, escaped(text));
}

void Canvas::path(const std::string& data, const std::string& fill, const LineStyle& style) {
  if (data.empty()) return;
  body_ += fmt::format("<path d=\"{}\" fill=\"{}\" {} stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
                       data, fill, stroke_of(style));
}

void Canvas::hatch(const std::string& data) {
  if (data.empty()) return;
  // Each has a pattern of its own, which no other picture of a page can take the place of.
  const std::string name = fmt::format("hatching-{}", body_.size());
  body_ += fmt::format(
      "<pattern id=\"{0}\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate(45)\"><path d=\"M0 0V6\" stroke=\"{1}\" stroke-width=\"1.2\"/></pattern>\n"
      "<path d=\"{2}\" fill=\"url(#{0})\"/>\n",
      name, grey, data);
}

std::string Canvas::document(double width, double height) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" fill=\"{2}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"{3}\"/>\n{4}</svg>\n",
      coordinate(width), coordinate(height), ink, paper, body_);
}

}  // namespace dda::svg
