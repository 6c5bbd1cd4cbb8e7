#include "framework/figure/plot.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "framework/figure/axis.hpp"
#include "framework/figure/canvas.hpp"
#include "framework/figure/placement.hpp"

namespace dda::svg {
namespace {

constexpr double plot_width = 300, plot_height = 225, margin = 14;
constexpr std::size_t most_columns = 3;
constexpr int most_ticks = 6;

using Colours = std::map<std::string, std::size_t>;

/// One colour per name, in order of appearance; nameless series take the first free ones of their panel.
Colours colours_of(const Figure& figure) {
  Colours colours;
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      if (series.name.empty()) continue;
      const std::size_t next = series.colour >= 0 ? static_cast<std::size_t>(series.colour) : colours.size();
      colours.emplace(series.name, next);
    }
  }
  return colours;
}

std::size_t colour_of(const Series& series, std::size_t position, const Colours& colours) {
  if (series.colour >= 0) return static_cast<std::size_t>(series.colour);
  return series.name.empty() ? position : colours.at(series.name);
}

LineStyle style_of(const Series& series, std::size_t colour) {
  // Beyond the palette the dashes tell two series of one colour apart.
  constexpr double dash_step =
      (dashes[0] + dashes[1]) / 3.0;  // three coinciding dashed curves share the period of the dashes
  return {palette[colour % palette.size()], 1.8, series.dashed != (colour / palette.size() % 2 == 1),
          dash_step * static_cast<double>(colour), series.dotted};
}

/// Draws one panel into its frame.
class PanelPainter {
 public:
  PanelPainter(Canvas& canvas, const Panel& panel, const Box& frame)
      : canvas_(canvas),
        panel_(panel),
        frame_(frame),
        x_(axis(panel.is_logarithmic_x, range(&Series::x, &Marker::x))),
        y_(axis(panel.is_logarithmic_y, range(&Series::y, &Marker::y))) {}

  /// Room for tick labels and axis label left of the frame.
  static double left_room(const Panel& panel) {
    Canvas unused;
    double widest = 0;
    for (const Tick& tick : PanelPainter(unused, panel, {}).y_.ticks) {
      widest = std::max(widest, text_width(tick.label, small_text));
    }
    return widest + 8 + (panel.y_label.empty() ? 0 : normal_text + 10);
  }

  void paint(const Colours& colours) {
    grid();
    labels();
    for (std::size_t i = 0; i < panel_.series.size(); ++i) {
      curve(panel_.series[i], style_of(panel_.series[i], colour_of(panel_.series[i], i, colours)));
    }
    if (all_tracks().empty()) {
      canvas_.text(frame_.x + frame_.width / 2, frame_.y + frame_.height / 2, "no data",
                   {normal_text, Anchor::middle});
    }
    markers();
  }

 private:
  static Axis axis(bool is_logarithmic, const Range& range) {
    return is_logarithmic ? make_logarithmic_axis(range, most_ticks) : make_axis(range, most_ticks);
  }

  /// What stands for a number on its axis; not finite where there is none.
  static double on_axis(bool is_logarithmic, double value) {
    return is_logarithmic ? std::log10(value) : value;
  }
  double on_x(double x) const { return on_axis(panel_.is_logarithmic_x, x); }
  double on_y(double y) const { return on_axis(panel_.is_logarithmic_y, y); }
  bool is_drawn(double x, double y) const { return std::isfinite(on_x(x)) && std::isfinite(on_y(y)); }

  Range range(std::vector<double> Series::*values, double Marker::*value) const {
    const bool is_logarithmic = value == &Marker::x ? panel_.is_logarithmic_x : panel_.is_logarithmic_y;
    Range result;
    for (const Series& series : panel_.series) {
      for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        if (is_drawn(series.x[i], series.y[i])) result.include(on_axis(is_logarithmic, (series.*values)[i]));
      }
    }
    for (const Marker& marker : panel_.markers) result.include(on_axis(is_logarithmic, marker.*value));
    return result.widened(axis_margin);
  }

  /// Of what stands for a number on its axis.
  double across(double on_x) const {
    return frame_.x + frame_.width * ((on_x - x_.range.low) / (x_.range.high - x_.range.low));
  }
  double down(double on_y) const {
    return frame_.bottom() - frame_.height * ((on_y - y_.range.low) / (y_.range.high - y_.range.low));
  }
  double px(double x) const { return across(on_x(x)); }
  double py(double y) const { return down(on_y(y)); }

  void grid() {
    canvas_.rectangle(frame_, paper, "none");
    for (const Tick& tick : x_.ticks) line_up(across(tick.value), tick.is_minor);
    for (const Tick& tick : y_.ticks) line_across(down(tick.value), tick.is_minor);
    if (!panel_.is_logarithmic_y && y_.range.low < 0 && y_.range.high > 0)
      canvas_.line({frame_.x, down(0), frame_.right(), down(0)}, {grey, 0.8});
    if (!panel_.is_logarithmic_x && x_.range.low < 0 && x_.range.high > 0)
      canvas_.line({across(0), frame_.y, across(0), frame_.bottom()}, {grey, 0.8});
    canvas_.rectangle(frame_, "none", ink);
  }

  /// Through the frame; of minor ticks short ones at its sides.
  void line_up(double x, bool is_minor) {
    canvas_.line({x, is_minor ? frame_.bottom() - minor_tick : frame_.y, x, frame_.bottom()},
                 {is_minor ? ink : faint, 0.8});
  }
  void line_across(double y, bool is_minor) {
    canvas_.line({frame_.x, y, is_minor ? frame_.x + minor_tick : frame_.right(), y},
                 {is_minor ? ink : faint, 0.8});
  }

  void labels() {
    double free_from = -1e9;
    for (const Tick& tick : x_.ticks) {
      const double half = text_width(tick.label, small_text) / 2, x = across(tick.value);
      if (tick.is_minor || x - half < free_from) continue;
      canvas_.text(x, frame_.bottom() + 15, tick.label, {small_text, Anchor::middle});
      free_from = x + half + 4;
    }
    for (const Tick& tick : y_.ticks) {
      canvas_.text(frame_.x - 6, down(tick.value) + 3.5, tick.label, {small_text, Anchor::end});
    }
    titles();
  }

  void titles() {
    const double middle = frame_.x + frame_.width / 2;
    canvas_.text(frame_.right(), frame_.bottom() + 27, x_.scale, {small_text, Anchor::end});
    const double room = frame_.width - (x_.scale.empty() ? 0 : 2 * text_width(x_.scale, small_text) + 16);
    canvas_.text(middle, frame_.bottom() + 32, fitted(panel_.x_label, normal_text, room),
                 {normal_text, Anchor::middle});
    canvas_.text(frame_.x, frame_.y - 6, y_.scale, {small_text});
    const double x = frame_.x - left_room(panel_) + normal_text;
    canvas_.text(x, frame_.y + frame_.height / 2, fitted(panel_.y_label, normal_text, frame_.height),
                 {normal_text, Anchor::middle, false, -90});
    const double rise = y_.scale.empty() ? 8 : 19;
    canvas_.text(middle, frame_.y - rise, fitted(panel_.title, normal_text, frame_.width),
                 {normal_text, Anchor::middle, true});
  }

  std::vector<Track> tracks(const Series& series) const {
    std::vector<Track> result;
    bool broken = true;
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      const bool finite = is_drawn(series.x[i], series.y[i]);
      if (finite && broken) result.emplace_back();
      if (finite) result.back().emplace_back(px(series.x[i]), py(series.y[i]));
      broken = !finite;
    }
    return result;
  }

  std::vector<Track> all_tracks() const {
    std::vector<Track> result;
    for (const Series& series : panel_.series) {
      for (Track& track : tracks(series)) result.push_back(std::move(track));
    }
    return result;
  }

  void curve(const Series& series, const LineStyle& style) {
    for (const Track& track : tracks(series)) {
      std::string data;
      for (const auto& [x, y] : track) {
        data += data.empty() ? 'M' : 'L';
        data += coordinate(x) + ' ' + coordinate(y);
      }
      // A single point shows as a dot: the round ends of a line of no length.
      if (track.size() == 1) {
        canvas_.path(data + "h0.01", "none", {style.colour, 5, false});
      } else {
        canvas_.path(data, "none", style);
      }
    }
  }

  void markers() {
    const Box inner{frame_.x + 2, frame_.y + 2, frame_.width - 4, frame_.height - 4};
    LabelPlacer placer(inner, all_tracks());
    for (const Marker& marker : panel_.markers) {
      if (shown(marker)) placer.keep_free({px(marker.x) - 5, py(marker.y) - 5, 10, 10});
    }
    for (const Marker& marker : panel_.markers) {
      if (!shown(marker)) continue;
      canvas_.circle(px(marker.x), py(marker.y), 4);
      const std::string label = fitted(marker.label, small_text, inner.width - 20);
      const Box box = placer.place(px(marker.x), py(marker.y), text_width(label, small_text), small_text);
      canvas_.text(box.x + box.width / 2, box.bottom() - 1.5, label, {small_text, Anchor::middle});
    }
  }

  bool shown(const Marker& marker) const { return is_drawn(marker.x, marker.y); }

  Canvas& canvas_;
  const Panel& panel_;
  Box frame_;
  Axis x_, y_;
};

struct LegendEntry {
  std::string name;
  LineStyle style;
};

std::vector<LegendEntry> legend_of(const Figure& figure, const Colours& colours) {
  std::vector<LegendEntry> entries;
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      const auto same = [&](const LegendEntry& entry) { return entry.name == series.name; };
      if (series.name.empty() || std::any_of(entries.begin(), entries.end(), same)) continue;
      entries.push_back({series.name, style_of(series, colour_of(series, 0, colours))});
    }
  }
  return entries;
}

/// Draws the entries in rows no wider than `width`, centred; gives the height used.
double paint_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, const Box& room) {
  constexpr double sample = 26, gap = 20, row_height = 18;
  double y = room.y;
  for (std::size_t first = 0; first < entries.size();) {
    double used = 0;
    std::vector<std::string> names;
    for (std::size_t i = first; i < entries.size(); ++i) {
      const std::string name = fitted(entries[i].name, small_text, room.width - sample - gap);
      const double more = sample + 6 + text_width(name, small_text) + gap;
      if (!names.empty() && used + more > room.width) break;
      names.push_back(name);
      used += more;
    }
    double x = room.x + std::max(0.0, (room.width - used + gap) / 2);
    for (std::size_t i = 0; i < names.size(); ++i) {
      canvas.line({x, y + 8, x + sample, y + 8}, entries[first + i].style);
      canvas.text(x + sample + 6, y + 11.5, names[i], {small_text});
      x += sample + 6 + text_width(names[i], small_text) + gap;
    }
    first += names.size();
    y += row_height;
  }
  return y - room.y;
}

std::size_t num_columns(std::size_t panels) {
  return panels == 4 ? 2 : std::clamp<std::size_t>(panels, 1, most_columns);
}

}  // namespace

std::string to_svg(const Figure& figure) {
  Canvas canvas;
  const Colours colours = colours_of(figure);
  const std::size_t columns = num_columns(figure.panels.size());
  double left = 30;
  for (const Panel& panel : figure.panels) left = std::max(left, PanelPainter::left_room(panel));
  const double cell_width = left + plot_width + 2 * margin;
  constexpr double above = 34, cell_height = above + plot_height + 40;
  const double width = static_cast<double>(columns) * cell_width + margin;
  double y = margin;
  if (!figure.title.empty()) {
    canvas.text(width / 2, y + large_text, fitted(figure.title, large_text, width - 2 * margin),
                {large_text, Anchor::middle, true});
    y += large_text + 8;
  }
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Box frame{margin + static_cast<double>(i % columns) * cell_width + left,
                    y + static_cast<double>(i / columns) * cell_height + above, plot_width, plot_height};
    PanelPainter(canvas, figure.panels[i], frame).paint(colours);
  }
  y += static_cast<double>((figure.panels.size() + columns - 1) / columns) * cell_height;
  y += paint_legend(canvas, legend_of(figure, colours), {margin, y + 4, width - 2 * margin, 0});
  return canvas.document(width, y + margin);
}

}  // namespace dda::svg
