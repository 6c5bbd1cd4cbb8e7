#include "studies/dda/figures/stability_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/figure/drawing.hpp"
#include "framework/files/run/results_reader.hpp"
#include "framework/files/whole_file.hpp"
#include "studies/dda/figures/material_colours.hpp"
#include "studies/dda/figures/stability_lines.hpp"
#include "studies/dda/record/stability_record.hpp"

namespace dda {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();  // interrupts a line
constexpr std::size_t most_stages = 6, most_modes = 6, most_blocks = 5000;

/// Where the part of a curve before a row begins: at the row before, or, when that one is of another stage, at the
/// load of the new stage in the same place.
class Beginnings {
 public:
  Beginnings(const CsvTable& curve, const std::string& y, const StageStarts& starts)
      : ys_(curve.numbers(y)), is_load_(y == column::load), starts_(starts) {
    if (curve.has(column::stage)) stages_ = curve.numbers(column::stage);
  }
  bool begins_stage(std::size_t row) const { return !stages_.empty() && stages_[row - 1] != stages_[row]; }
  double before(std::size_t row) const {
    if (!is_load_ || !begins_stage(row)) return ys_[row - 1];
    const auto known = starts_.find(static_cast<int>(stages_[row]));
    return known == starts_.end() ? 0 : known->second;
  }

 private:
  std::vector<double> ys_, stages_;
  bool is_load_;
  const StageStarts& starts_;
};

/// The pieces of a curve, one for each kind of stability, with gaps where it is of another, and between stages.
std::array<svg::Series, 4> pieces_of(const StagedCurve& curve, const std::string& x, const std::string& y,
                                     const std::vector<Stability>& kinds) {
  const auto xs = curve.table.numbers(x), ys = curve.table.numbers(y);
  const Beginnings beginnings(curve.table, y, curve.starts);
  std::array<svg::Series, 4> out;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    svg::Series& piece = out[static_cast<std::size_t>(kinds[i])];
    if (i == 0 || kinds[i - 1] != kinds[i] || beginnings.begins_stage(i + 1)) {
      if (!piece.x.empty()) {
        piece.x.push_back(gap);
        piece.y.push_back(gap);
      }
      piece.x.push_back(xs[i]);
      piece.y.push_back(beginnings.before(i + 1));
    }
    piece.x.push_back(xs[i + 1]);
    piece.y.push_back(ys[i + 1]);
  }
  return out;
}

/// Where what is known of a run's eigenvalues stands in its curve.
class Eigenvalues {
 public:
  explicit Eigenvalues(const CsvTable& curve)
      : steps_(curve.numbers(column::step)), load_(curve.numbers(column::load)) {
    for (std::size_t i = 1; curve.has(column::mu(i)); ++i) {
      values_.push_back(curve.numbers(column::mu(i)));
      ratios_.push_back(curve.numbers(column::mu_ratio(i)));
    }
    rigid_ = curve.numbers(column::rigid_modes);
  }
  std::size_t count() const { return values_.size(); }
  std::size_t row_of(int step) const {
    return static_cast<std::size_t>(std::ranges::find(steps_, step) - steps_.begin());
  }
  double load(std::size_t row) const { return load_[row]; }
  std::string value(std::size_t row, std::size_t i) const {
    int softer = 0;
    for (const auto& other : values_) softer += std::abs(other[row]) < std::abs(values_[i][row]);
    return fmt::format("μ = {:.4g}{}", values_[i][row], softer < rigid_[row] ? ", rigid" : "");
  }
  /// Which of the first modes the i-th lowest at a row is: "mode 2, μ/μ₀ = 0.85".
  std::string origin(std::size_t row, std::size_t i) const {
    const double value = values_[i][row];
    for (std::size_t k = 0; k < ratios_.size(); ++k) {
      constexpr double same = 1e-9;
      const double of_first = ratios_[k][row] * values_[k].front();
      if (std::abs(of_first - value) <= same * std::abs(value))
        return fmt::format("mode {}, μ/μ₀ = {:.3g}", k + 1, ratios_[k][row]);
    }
    return "not among the first";
  }

 private:
  std::vector<double> steps_, load_, rigid_;
  std::vector<std::vector<double>> values_, ratios_;
};

/// First, last, and as many in between as a sheet has room for.
std::vector<int> stages_of(const ResultsReader& results) {
  std::vector<int> with_modes, out;
  for (const int step : results.steps())
    if (results.has(step, "mode_1")) with_modes.push_back(step);
  const std::size_t n = with_modes.size(), rows = std::min(n, most_stages);
  for (std::size_t i = 0; i < rows; ++i) out.push_back(with_modes[rows == 1 ? 0 : i * (n - 1) / (rows - 1)]);
  return out;
}

/// The shapes of one run side by side.
class ModeSheet {
 public:
  ModeSheet(const ResultsReader& results, const Fields& fields, const CsvTable& curve,
            const Measures& measures)
      : results_(results), fields_(fields), eigenvalues_(curve), unit_(measures.load_unit()) {
    for (const Block& block : fields.body().assembly.blocks)
      for (const Vec2& x : block.outline.vertices) box_.include(x);
  }

  svg::Drawing draw() const {
    svg::Drawing out{.title = "Modes of the physical stiffness",
                     .caption =
                         "rows: stages of the path; first column: deformed blocks; others: lowest "
                         "eigenvalues of K φ = μ M φ; μ₀: of the same shape at the start"};
    constexpr double room_of_shape = 190;  // [px]
    const std::size_t modes = std::min(eigenvalues_.count(), most_modes);
    out.width = room_of_shape * static_cast<double>(1 + modes);
    out.height = 1e5;
    double down = 0;
    for (const int step : stages_of(results_)) {
      const std::size_t row = eigenvalues_.row_of(step);
      add_state(out, {0, -down}, step, row);
      for (std::size_t i = 0; i < modes; ++i)
        if (const auto name = fmt::format("mode_{}", i + 1); results_.has(step, name))
          add(out, {static_cast<double>(i + 1) * width(), -down}, upright(shape_of(step, name)),
              {eigenvalues_.value(row, i), eigenvalues_.origin(row, i)});
      down += height();
    }
    explain(colours_, out);
    return out;
  }

 private:
  Vec2 size() const { return box_.high - box_.low; }
  double largest() const { return 0.12 * box_.size(); }  // displacement drawn
  double line() const { return 0.075 * width(); }        // of text
  double width() const { return 1.15 * size().x() + 1.2 * largest(); }
  double height() const { return size().y() + 2 * largest() + 3.5 * line(); }

  /// Outlines of blocks, of those that are cut of their parts, and how each vertex moves.
  struct Shape {
    std::vector<std::vector<Vec2>> outlines;
    std::vector<std::size_t> blocks;  ///< to which they belong
    std::vector<Vec2> moves;

    void scale(double factor) {
      for (Vec2& move : moves) move *= factor;
    }
  };

  Shape shape_of(int step, const std::string& name) const {
    Shape out;
    const CutBlocks cut = results_.cut(step);
    const auto add = [&](const std::vector<Vec2>& outline, const std::vector<double>& moved,
                         std::size_t first, std::size_t block) {
      out.outlines.push_back(outline);
      out.blocks.push_back(block);
      for (std::size_t v = first; v < first + outline.size(); ++v)
        out.moves.emplace_back(moved[3 * v], moved[3 * v + 1]);
    };
    const std::vector<double> of_blocks = results_.values(step, name);
    for (std::size_t b = 0, first = 0; b < fields_.body().assembly.num_blocks(); ++b) {
      const std::vector<Vec2> outline = fields_.outline(BlockId{b});
      if (!std::ranges::binary_search(cut.part_block, b)) add(outline, of_blocks, first, b);
      first += outline.size();
    }
    if (cut.parts.empty()) return out;
    const std::vector<double> of_parts = results_.values(step, "parts/" + name);
    for (std::size_t part = 0, vertex = 0; part < cut.parts.size(); ++part) {
      add(cut.parts[part], of_parts, vertex, cut.part_block[part]);
      vertex += cut.parts[part].size();
    }
    return out;
  }

  /// A shape has no sign: most of it goes upwards.
  static Shape upright(Shape shape) {
    double sum = 0;
    for (const Vec2& move : shape.moves) sum += move.y() + 1e-3 * move.x();
    if (sum < 0) shape.scale(-1);
    return shape;
  }

  /// The deformed structure at a stage.
  void add_state(svg::Drawing& out, const Vec2& shift, int step, std::size_t row) const {
    Shape shape = shape_of(step, "displacement");
    double top = 0;
    for (const Vec2& move : shape.moves) top = std::max(top, move.norm());
    if (top > 0) shape.scale(1 / top);
    add(out, shift, shape,
        {fmt::format("step {}", step), fmt::format("load {:.4g} {}", eigenvalues_.load(row), unit_)});
  }

  void add(svg::Drawing& out, const Vec2& shift, const Shape& shape,
           const std::vector<std::string>& texts) const {
    const double scale = largest();
    auto move = shape.moves.begin();
    for (std::size_t i = 0; i < shape.outlines.size(); ++i) {
      svg::Fill fill{.tint = colours_.of(fields_.body().block(BlockId{shape.blocks[i]}))};
      for (const Vec2& x : shape.outlines[i]) fill.outline.push_back(x + shift + scale * *move++);
      out.polygons.push_back(std::move(fill));
    }
    Vec2 below(box_.low.x() + 0.5 * size().x(), box_.low.y() - largest());
    for (const std::string& text : texts) {
      below.y() -= line();
      out.notes.push_back({below + shift, text});
    }
  }

  const ResultsReader& results_;
  const Fields& fields_;
  Eigenvalues eigenvalues_;
  MaterialColours colours_ = material_colours(fields_.body().assembly);
  std::string unit_;
  Box box_;
};

/// A column over another, without the rows at which it was not computed.
svg::Series known(const CsvTable& curve, const std::string& x, const std::string& y) {
  const auto xs = curve.numbers(x), ys = curve.numbers(y);
  svg::Series out;
  for (std::size_t i = 0; i < ys.size(); ++i) {
    if (!std::isfinite(ys[i])) continue;
    out.x.push_back(xs[i]);
    out.y.push_back(ys[i]);
  }
  return out;
}

svg::Figure over_the_path(const CsvTable& curve, const Measures& measures) {
  const bool has_gauge = !measures.displacements().empty();
  const Column x = has_gauge ? measures.names()[measures.displacements().front()]
                             : Column{column::dissipated_energy, measures.energy_unit()};
  const std::string label = x.unit.empty() ? x.name : fmt::format("{} [{}]", x.name, x.unit);
  svg::Panel ratios{.title = "eigenvalues", .x_label = label, .y_label = "μ/μ₀, drawn down to −1"};
  for (std::size_t i = 1; curve.has(column::mu_ratio(i)); ++i) {
    svg::Series series = known(curve, x.name, column::mu_ratio(i));
    for (double& ratio : series.y) ratio = std::max(ratio, -1.0);  // a steep crack would dwarf all the others
    series.name = fmt::format("mode {}", i);
    ratios.series.push_back(std::move(series));
  }
  svg::Panel bergan{.title = "current stiffness", .x_label = label, .y_label = "(ṗ/u̇)/(ṗ/u̇)₀"};
  bergan.series.push_back(known(curve, x.name, column::current_stiffness));
  return {.panels = {std::move(ratios), std::move(bergan)}};
}

}  // namespace

std::vector<svg::Series> by_stability(const StagedCurve& curve, const std::string& x, const std::string& y) {
  auto pieces = pieces_of(curve, x, y, between(stability_of(curve.table)));
  std::vector<svg::Series> out;
  for (std::size_t kind = 0; kind < pieces.size(); ++kind) {
    if (pieces[kind].x.empty()) continue;
    svg::Series& piece = pieces[kind];
    const StabilityLine& line = stability_lines[kind];
    piece.name = line.name;
    piece.colour = std::max(line.colour, svg::blue);
    piece.dashed = line.dashed;
    piece.dotted = line.dotted;
    out.push_back(std::move(piece));
  }
  if (out.empty()) return {{"", curve.table.numbers(x), curve.table.numbers(y)}};
  if (out.size() == 1 && out.front().name == stability_lines.front().name) out.front().name.clear();
  return out;
}

std::vector<svg::Series> by_stability(const StagedCurve& curve, const std::string& x, const std::string& y,
                                      const LegendEntry& entry) {
  std::vector<svg::Series> out{{.name = entry.name, .colour = entry.colour}};
  for (svg::Series& piece : by_stability(curve, x, y)) {
    piece.name.clear();
    piece.colour = entry.colour;
    out.push_back(std::move(piece));
  }
  return out;
}

svg::Series whole(const StagedCurve& curve, const std::string& x, const std::string& y) {
  const std::size_t rows = curve.table.num_rows();
  if (rows < 2) return {.x = curve.table.numbers(x), .y = curve.table.numbers(y)};
  return pieces_of(curve, x, y, std::vector<Stability>(rows - 1, Stability::stable)).front();
}

void write_stability_pictures(const RunFolder& folder, const Fields& fields, const Measures& measures) {
  const CsvTable curve = read_csv(folder.file("curve.csv"));
  if (!curve.has(column::mu(1))) return;
  write_whole(folder.file("eigenvalues.svg"), svg::to_svg(over_the_path(curve, measures)), Flush::to_system);
  if (fields.equilibrium().num_blocks() > most_blocks) return;
  const ResultsReader results(folder.path());
  write_whole(folder.file("modes.svg"), svg::to_svg(ModeSheet(results, fields, curve, measures).draw()),
              Flush::to_system);
}

}  // namespace dda
