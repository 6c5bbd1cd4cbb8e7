#include "studies/dda/figures/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/figure/axis.hpp"
#include "framework/figure/drawing.hpp"
#include "framework/figure/style.hpp"
#include "framework/files/whole_file.hpp"
#include "studies/dda/figures/material_colours.hpp"
#include "studies/dda/figures/stability_pictures.hpp"
#include "studies/dda/record/path/peak.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

/// Where a peak known from elsewhere stands on the panel of a gauge.
void mark(const std::optional<ReferencePeak>& reference, const std::string& gauge, svg::Panel& panel) {
  if (!reference || !reference->at.contains(gauge)) return;
  panel.markers.push_back({reference->at.at(gauge), reference->load, reference->text});
}

StageStarts starts_of(const RunMemory& memory) {
  StageStarts out;
  for (const HeldStage& stage : memory.stages) out[stage.next.number] = stage.next.load;
  return out;
}

svg::Panel panel(const CsvTable& curve, const Measures& measures, const RunMemory& memory,
                 std::size_t gauge) {
  const auto& [name, unit] = measures.names()[gauge];
  svg::Panel out{
      .title = name, .x_label = with_unit(name, unit), .y_label = with_unit("load", measures.load_unit())};
  out.series = by_stability({curve, starts_of(memory)}, name, column::load);
  if (const int step = memory.peak.step; step > 0)
    out.markers.push_back(
        {memory.peak.values[gauge], memory.peak.load,
         fmt::format("{}, {:.4g} {}",
                     is_passed(curve, static_cast<std::size_t>(step)) ? "limit point" : "largest load",
                     memory.peak.load, measures.load_unit())});
  return out;
}

/// Load against the dissipated energy: what a deck without displacement gauges still tells.
svg::Panel energy_panel(const CsvTable& curve, const Measures& measures, const RunMemory& memory) {
  return {.x_label = with_unit("dissipated energy", measures.energy_unit()),
          .y_label = with_unit("load", measures.load_unit()),
          .series = by_stability({curve, starts_of(memory)}, column::dissipated_energy, column::load)};
}

/// The branch that was not taken.
void add_primary(const fs::path& file, const std::string& gauge, svg::Panel& panel) {
  if (!fs::exists(file)) return;
  const CsvTable primary = read_csv(file);
  panel.series.insert(panel.series.begin(), {.name = "without switching",
                                             .x = primary.numbers(gauge),
                                             .y = primary.numbers(column::load),
                                             .colour = svg::black});
}

svg::Figure curves(const RunFolder& folder, const Measures& measures, const RunMemory& memory,
                   const std::optional<ReferencePeak>& reference) {
  const CsvTable curve = read_csv(folder.file("curve.csv"));
  svg::Figure out;
  for (const std::size_t gauge : measures.displacements()) {
    out.panels.push_back(panel(curve, measures, memory, gauge));
    add_primary(folder.file("primary") / "curve.csv", measures.names()[gauge].name, out.panels.back());
    mark(reference, measures.names()[gauge].name, out.panels.back());
  }
  if (out.panels.empty()) out.panels.push_back(energy_panel(curve, measures, memory));
  return out;
}

/// Bounds of the undeformed structure.
Box bounds(const Fields& fields) {
  Box out;
  for (const Block& block : fields.body().assembly.blocks)
    for (const Vec2& x : block.outline.vertices) out.include(x);
  return out;
}

/// What the colour of a crack tells.
struct CrackQuantity {
  const char *name, *suffix;  ///< in the label and the name of the file
  double (*value)(const Vec2& w);
};
constexpr std::array<CrackQuantity, 2> crack_quantities{
    {{"opening", "", [](const Vec2& w) { return std::max(w.x(), 0.0); }},
     {"sliding", "-sliding", [](const Vec2& w) { return std::abs(w.y()); }}}};

constexpr double rounding = 1e-9;                          ///< of the least jump that is seen
constexpr double hairline_width = 0.6, crack_width = 1.5;  // [pt]

/// Draws one deformed state, shifted. Blocks have the colour of their material.
class DeformedState {
 public:
  DeformedState(const Fields& fields, const StoredState& at, Vec2 shift, double scale)
      : fields_(fields),
        at_(at),
        shift_(std::move(shift)),
        scale_(scale),
        colours_(material_colours(fields.body().assembly)),
        visible_(svg::hairline * bounds(fields).size() / scale) {}

  DeformedState& coloured_by(const CrackQuantity& quantity) {
    quantity_ = &quantity;
    return *this;
  }

  /// Leaves out the blocks whose centroids, and the cracks whose points, lie outside a rectangle.
  DeformedState& within(const Box& box) {
    box_ = box;
    return *this;
  }

  /// Marks the blocks that have been torn out.
  DeformedState& marking(const std::vector<TornPiece>& torn) {
    for (const TornPiece& piece : torn)
      marked_.insert(marked_.end(), piece.blocks.begin(), piece.blocks.end());
    return *this;
  }

  void add_to(svg::Drawing& drawing) const {
    for (std::size_t b = 0; b < fields_.equilibrium().num_blocks(); ++b) {
      if (!shows(fields_.body().block(BlockId(b)).moments.centroid)) continue;
      for (const auto& part : fields_.moved_parts(BlockId(b), at_.state.d)) {
        svg::Fill fill;
        fill.tint = colours_.of(fields_.body().block(BlockId(b)));
        fill.is_marked = std::ranges::find(marked_, BlockId(b)) != marked_.end();
        for (const auto& [x, u] : part) fill.outline.push_back(moved(x, u));
        drawing.polygons.push_back(std::move(fill));
      }
    }
    add_cracks(drawing);
  }

 private:
  bool shows(const Vec2& x) const { return !box_ || box_->contains(x); }
  Vec2 moved(const Vec2& x, const Vec2& u) const { return x + shift_ + scale_ * u; }

  void add_cracks(svg::Drawing& drawing) const {
    const Fields::Interface interface = fields_.interface_at(at_);
    for (std::size_t p = 0; p < interface.damage.size(); ++p) {
      if (interface.damage[p] <= 0) continue;
      const InterfacePoint& point = fields_.equilibrium().point(p);
      if (!shows(point.x)) continue;
      const auto between = [&](const Vec2& x) {
        return moved(x, fields_.displacement_between(p, x, at_.state.d));
      };
      const auto& [start, end] = fields_.segment(p);
      const Vec2& w = interface.opening[p];
      const double value = quantity_->value(w);
      drawing.strokes.push_back({between(start), between(end), value > rounding * visible_ ? value : 0,
                                 w.norm() < visible_ ? hairline_width : crack_width});
    }
  }

  const Fields& fields_;
  const StoredState& at_;
  Vec2 shift_;
  double scale_;
  MaterialColours colours_;
  double visible_;  ///< least jump that is seen [L]
  const CrackQuantity* quantity_ = crack_quantities.data();
  std::optional<Box> box_;
  std::vector<BlockId> marked_;
};

/// Mean displacement of the blocks in a rectangle, and the largest deviation from it.
struct Motion {
  Vec2 mean = Vec2::Zero();
  double spread = 0;
};
Motion motion_within(const Fields& fields, const State& state, const Box& box) {
  std::vector<Vec2> moves;
  Motion out;
  for (std::size_t b = 0; b < fields.equilibrium().num_blocks(); ++b)
    if (box.contains(fields.body().block(BlockId(b)).moments.centroid)) {
      moves.emplace_back(Eigen::Map<const Vec2>(state.d.data() + block_unknowns * b));
      out.mean += moves.back();
    }
  if (!moves.empty()) out.mean /= static_cast<double>(moves.size());
  for (const Vec2& move : moves) out.spread = std::max(out.spread, (move - out.mean).norm());
  return out;
}

svg::Drawing deformed(const Fields& fields, const PictureContent& content, const CrackQuantity& quantity) {
  const auto& [memory, end, record, torn] = content;
  const Box box = bounds(fields);
  const double height = (box.high - box.low).y();
  const double of_end = magnification(fields, end.state);
  svg::Drawing out{.title = "Deformed blocks and cracks",
                   .caption = fmt::format("end: displacements × {:g}", of_end),
                   .stroke_label = with_unit(quantity.name, fields.mesh().length_unit)};
  DeformedState(fields, end, Vec2::Zero(), of_end).coloured_by(quantity).marking(torn).add_to(out);
  explain(material_colours(fields.body().assembly), out);
  if (!memory.peak_state || memory.peak_state->step == end.step) return out;
  const double of_peak = magnification(fields, memory.peak_state->state);
  const Vec2 above(0, 1.2 * height + 0.1 * box.size());
  DeformedState(fields, *memory.peak_state, above, of_peak).coloured_by(quantity).marking(torn).add_to(out);
  out.caption =
      fmt::format("above: at the peak (step {}), displacements × {:g}; below: at the end (step {}), × {:g}",
                  memory.peak_state->step, of_peak, end.step, of_end);
  out.caption += "; thin lines: cracks whose jump is too small to be seen here";
  if (!torn.empty()) out.caption += "; red: torn out";
  return out;
}

svg::Drawing detail_of(const Fields& fields, const Detail& detail, const StoredState& end,
                       const CrackQuantity& quantity) {
  Box box;
  for (const Spot& corner : {detail.from, detail.to}) box.include(locate(fields.body().assembly, corner));
  const Motion motion = motion_within(fields, end.state, box);
  const double scale = motion.spread > 0 ? svg::round_down(0.1 * box.size() / motion.spread) : 1;
  svg::Drawing out{.title = "Detail at the end",
                   .caption = fmt::format("step {}, displacements × {:g}", end.step, scale),
                   .stroke_label = with_unit(quantity.name, fields.mesh().length_unit)};
  DeformedState(fields, end, -scale * motion.mean, scale).within(box).coloured_by(quantity).add_to(out);
  explain(material_colours(fields.body().assembly), out);
  return out;
}

}  // namespace

double magnification(const Fields& fields, const State& state) {
  double largest = 0;
  for (std::size_t b = 0; b < fields.equilibrium().num_blocks(); ++b)
    largest = std::max(largest, Eigen::Map<const Vec2>(state.d.data() + block_unknowns * b).norm());
  return largest > 0 ? svg::round_down(std::max(0.05 * bounds(fields).size() / largest, 1e-12)) : 1;
}

void write_pictures(const RunFolder& folder, const Fields& fields, const Measures& measures,
                    const PictureContent& content) {
  const auto& [memory, end, record, torn] = content;
  const auto write = [&](const std::string& name, const std::string& text) {
    write_whole(folder.file(name + ".svg"), text, Flush::to_system);
  };
  write("curve", svg::to_svg(curves(folder, measures, memory, record.reference_peak)));
  if (fields.equilibrium().num_blocks() > most_drawn_blocks) return;
  for (const CrackQuantity& quantity : crack_quantities) {
    write(std::string("deformed") + quantity.suffix, svg::to_svg(deformed(fields, content, quantity)));
    if (record.detail)
      write(std::string("detail") + quantity.suffix,
            svg::to_svg(detail_of(fields, *record.detail, end, quantity)));
  }
}

}  // namespace dda
