#include "studies/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/output/svg/drawing.hpp"
#include "studies/stability_pictures.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

svg::Panel panel(const CsvTable& curve, const Measures& measures, const RunMemory& memory,
                 std::size_t gauge) {
  const Column& column = measures.names()[gauge];
  svg::Panel out{.title = column.name,
                 .x_label = with_unit(column.name, column.unit),
                 .y_label = with_unit("load", measures.load_unit()),
                 .series = {},
                 .markers = {}};
  out.series = by_stability(curve, column.name, "load");
  if (memory.peak.step > 0)
    out.markers.push_back({memory.peak.values[gauge], memory.peak.load,
                           fmt::format("limit point, {:.4g} {}", memory.peak.load, measures.load_unit())});
  return out;
}

/// Load against the dissipated energy: what a deck without displacement gauges still tells.
svg::Panel energy_panel(const CsvTable& curve, const Measures& measures) {
  return {.title = "",
          .x_label = with_unit("dissipated energy", measures.columns()[4].unit),
          .y_label = with_unit("load", measures.load_unit()),
          .series = {{"", curve.numbers("dissipated_energy"), curve.numbers("load")}},
          .markers = {}};
}

/// The branch that was not taken.
void add_primary(const fs::path& file, const std::string& gauge, svg::Panel& panel) {
  if (!fs::exists(file)) return;
  const CsvTable primary = read_csv(file);
  constexpr int black = 6;
  panel.series.insert(panel.series.begin(), {.name = "without switching",
                                             .x = primary.numbers(gauge),
                                             .y = primary.numbers("load"),
                                             .colour = black});
}

svg::Figure curves(const RunFolder& folder, const Measures& measures, const RunMemory& memory) {
  const CsvTable curve = read_csv(folder.file("curve.csv"));
  svg::Figure out;
  for (const std::size_t gauge : measures.displacements()) {
    out.panels.push_back(panel(curve, measures, memory, gauge));
    add_primary(folder.file("primary") / "curve.csv", measures.names()[gauge].name, out.panels.back());
  }
  if (out.panels.empty()) out.panels.push_back(energy_panel(curve, measures));
  return out;
}

/// Bounds of the undeformed structure.
Box bounds(const Fields& fields) {
  Box out;
  for (const Block& block : fields.body().assembly.blocks)
    for (const Vec2& x : block.outline.vertices) out.include(x);
  return out;
}

/// 1, 2 or 5 times a power of ten, at most `value`.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

/// Makes the largest displacement about 5 % of the structure.
double magnification(const Fields& fields, const State& state, double size) {
  double largest = 0;
  for (std::size_t b = 0; b < fields.equilibrium().num_blocks(); ++b)
    largest = std::max(largest, Eigen::Map<const Vec2>(state.d.data() + block_unknowns * b).norm());
  return largest > 0 ? round_down(std::max(0.05 * size / largest, 1e-12)) : 1;
}

/// Draws one deformed state, shifted.
class DeformedState {
 public:
  DeformedState(const Fields& fields, const StoredState& at, Vec2 shift, double scale)
      : fields_(fields), at_(at), shift_(std::move(shift)), scale_(scale) {}

  void add_to(svg::Drawing& drawing) const {
    for (std::size_t b = 0; b < fields_.equilibrium().num_blocks(); ++b) {
      svg::Fill fill;
      for (const Vec2& x : fields_.body().assembly.blocks[b].outline.vertices)
        fill.outline.push_back(moved(x, fields_.displacement(BlockId(b), x, at_.state.d)));
      drawing.polygons.push_back(std::move(fill));
    }
    add_cracks(drawing);
  }

 private:
  Vec2 moved(const Vec2& x, const Vec2& u) const { return x + shift_ + scale_ * u; }

  void add_cracks(svg::Drawing& drawing) const {
    const Fields::Interface interface = fields_.interface_at(at_);
    for (std::size_t p = 0; p < interface.damage.size(); ++p) {
      if (interface.damage[p] <= 0) continue;
      const InterfacePoint& point = fields_.equilibrium().point(p);
      const auto between = [&](const Vec2& x) {
        return moved(x, (fields_.displacement(point.first, x, at_.state.d) +
                         fields_.displacement(point.second, x, at_.state.d)) /
                            2);
      };
      const auto& [start, end] = fields_.segment(p);
      drawing.strokes.push_back({between(start), between(end), interface.opening[p].norm()});
    }
  }

  const Fields& fields_;
  const StoredState& at_;
  Vec2 shift_;
  double scale_;
};

svg::Drawing deformed(const Fields& fields, const RunMemory& memory, const StoredState& end,
                      const std::string& unit) {
  const Box box = bounds(fields);
  const double height = (box.high - box.low).y();
  const double of_end = magnification(fields, end.state, box.size());
  svg::Drawing out{.title = "Deformed blocks and cracks",
                   .caption = fmt::format("end: displacements × {:g}", of_end),
                   .polygons = {},
                   .polygon_label = "",
                   .strokes = {},
                   .stroke_label = fmt::format("opening [{}]", unit)};
  DeformedState(fields, end, Vec2::Zero(), of_end).add_to(out);
  if (!memory.peak_state || memory.peak_state->step == end.step) return out;
  const double of_peak = magnification(fields, memory.peak_state->state, box.size());
  const Vec2 above(0, 1.2 * height + 0.1 * box.size());
  DeformedState(fields, *memory.peak_state, above, of_peak).add_to(out);
  out.caption =
      fmt::format("above: at the peak (step {}), displacements × {:g}; below: at the end (step {}), × {:g}",
                  memory.peak_state->step, of_peak, end.step, of_end);
  return out;
}

}  // namespace

void write_pictures(const RunFolder& folder, const Fields& fields, const Measures& measures,
                    const RunMemory& memory, const StoredState& end) {
  write_whole(folder.file("curve.svg"), svg::to_svg(curves(folder, measures, memory)), Flush::to_system);
  constexpr std::size_t most_blocks = 20000;
  if (fields.equilibrium().num_blocks() > most_blocks) return;
  write_whole(folder.file("deformed.svg"),
              svg::to_svg(deformed(fields, memory, end, fields.mesh().length_unit)), Flush::to_system);
}

}  // namespace dda
