#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "framework/files/run/base64.hpp"
#include "studies/dda/figures/material_colours.hpp"
#include "studies/dda/report/report.hpp"

namespace dda::report {
namespace {

/// Numbers as 16 bits: value = scale · integer. The error is 1/65534 of the largest; of zeros the scale is
/// zero.
Json quantised(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const double scale = largest / 32767;
  const auto integer = [&](double value) {
    return static_cast<std::int16_t>(scale > 0 && std::isfinite(value) ? std::lround(value / scale) : 0);
  };
  std::vector<std::int16_t> integers;
  integers.reserve(values.size());
  for (const double value : values) integers.push_back(integer(value));
  return {{"scale", scale}, {"integers", base64_of(std::span<const std::int16_t>(integers))}};
}

std::string singles(const std::vector<double>& values) {
  const std::vector<float> shorter(values.begin(), values.end());
  return base64_of(std::span<const float>(shorter));
}

std::string integers(const std::vector<std::uint32_t>& values) {
  return base64_of(std::span<const std::uint32_t>(values));
}

/// u(x) = u0 + G (x − c), c the mean of the vertices: the whole motion of a block of uniform strain.
struct Motion {
  Vec2 mean = Vec2::Zero();
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
};

/// By least squares over the vertices; `moved` holds three components for each.
Motion motion_of(const std::vector<Vec2>& outline, const double* moved) {
  const auto count = static_cast<double>(outline.size());
  Vec2 centre = Vec2::Zero();
  Motion out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    centre += outline[i] / count;
    out.mean += Vec2(moved[3 * i], moved[3 * i + 1]) / count;
  }
  Eigen::Matrix2d product = Eigen::Matrix2d::Zero(), moment = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 x = outline[i] - centre, u = Vec2(moved[3 * i], moved[3 * i + 1]) - out.mean;
    product += u * x.transpose();
    moment += x * x.transpose();
  }
  if (moment.determinant() > 0) out.gradient = product * moment.inverse();
  return out;
}

using Outlines = std::vector<std::vector<Vec2>>;

Json motions(const Outlines& outlines, const std::vector<double>& moved) {
  std::vector<double> means, gradients;
  const double* next = moved.data();
  for (const auto& outline : outlines) {
    const Motion motion = motion_of(outline, next);
    means.insert(means.end(), {motion.mean.x(), motion.mean.y()});
    const Eigen::Matrix2d& g = motion.gradient;
    gradients.insert(gradients.end(), {g(0, 0), g(0, 1), g(1, 0), g(1, 1)});
    next += 3 * outline.size();
  }
  return {{"mean", quantised(means)}, {"gradient", quantised(gradients)}};
}

std::vector<std::uint32_t> damaged(const std::vector<double>& damage) {
  std::vector<std::uint32_t> out;
  for (std::size_t p = 0; p < damage.size(); ++p)
    if (damage[p] > 0) out.push_back(static_cast<std::uint32_t>(p));
  return out;
}

/// Interface points with damage: where their ends move, opening max(w_n, 0), sliding |w_s| and damage.
struct Cracked {
  std::vector<std::uint32_t> points;
  std::vector<double> opening, sliding, damage, ends;

  /// Those of a group of the step; their numbers in it.
  std::vector<std::uint32_t> add(const ResultsReader& results, int step, const std::string& group) {
    if (!results.has(step, group + "/damage")) return {};
    const std::vector<double> of_all = results.values(step, group + "/damage");
    const std::vector<double> w = results.values(step, group + "/opening");
    const std::vector<double> moved = results.values(step, group + "/displacement");
    const std::vector<std::uint32_t> found = damaged(of_all);
    for (const std::uint32_t p : found) {
      opening.push_back(std::max(w[3 * p], 0.0));
      sliding.push_back(std::abs(w[3 * p + 1]));
      damage.push_back(of_all[p]);
      for (const std::size_t i : {6 * p, 6 * p + 1, 6 * p + 3, 6 * p + 4}) ends.push_back(moved[i]);
    }
    return found;
  }
};

/// `points` are segments of the mesh; the rest has its own places, `pieces`: of cracks through blocks.
Json cracks(const ResultsReader& results, const CutBlocks& cut, int step) {
  Cracked all;
  const std::vector<std::uint32_t> points = all.add(results, step, "segments");
  std::vector<double> pieces;
  for (const std::uint32_t p : all.add(results, step, "cracks"))
    for (const Vec2& x : cut.pieces[p]) pieces.insert(pieces.end(), {x.x(), x.y()});
  return {{"points", integers(points)},      {"pieces", singles(pieces)},
          {"opening", singles(all.opening)}, {"sliding", singles(all.sliding)},
          {"damage", singles(all.damage)},   {"ends", quantised(all.ends)}};
}

/// Numbers of vertices, and their places.
std::pair<std::vector<std::uint16_t>, std::vector<double>> flat(const Outlines& outlines) {
  std::vector<std::uint16_t> counts;
  std::vector<double> vertices;
  for (const auto& outline : outlines) {
    for (const Vec2& x : outline) vertices.insert(vertices.end(), {x.x(), x.y()});
    counts.push_back(static_cast<std::uint16_t>(outline.size()));
  }
  return {std::move(counts), std::move(vertices)};
}

/// Names of materials, and for each block the place of its own among them.
void add_materials(const ResultsReader& results, const ResultsMesh& mesh, Json& out) {
  const MaterialColours colours = material_colours(results.region_materials());
  const auto known = static_cast<int>(colours.of_region.size());
  std::vector<std::uint16_t> of_block;
  for (const int region : mesh.block_region) {
    if (region < 0 || region >= known) return;
    of_block.push_back(static_cast<std::uint16_t>(colours.of_region[static_cast<std::size_t>(region)]));
  }
  if (of_block.size() != mesh.blocks.size()) return;
  out["materials"] = colours.names;
  out["material_of"] = base64_of(std::span<const std::uint16_t>(of_block));
}

Json geometry(const ResultsReader& results, const ResultsMesh& mesh) {
  const auto [counts, vertices] = flat(mesh.blocks);
  std::vector<double> segments;
  for (const auto& [start, end] : mesh.segments)
    segments.insert(segments.end(), {start.x(), start.y(), end.x(), end.y()});
  Json out{{"length_unit", mesh.length_unit},
           {"counts", base64_of(std::span<const std::uint16_t>(counts))},
           {"vertices", singles(vertices)},
           {"segments", singles(segments)}};
  add_materials(results, mesh, out);
  return out;
}

constexpr std::size_t coded(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

/// Characters that a step takes on the page.
std::size_t size_of_step(const ResultsReader& results, int step, std::size_t num_blocks) {
  constexpr std::size_t of_block = 2 * (2 + 4 + 3), of_crack = 4 * 4 + 4 * 2, frame = 600;
  std::size_t out = coded(of_block * num_blocks) + frame;
  for (const char* points : {"segments/damage", "cracks/damage"})
    if (results.has(step, points)) out += coded(of_crack * damaged(results.values(step, points)).size());
  constexpr std::size_t of_vertex = 2 * 4, of_part = of_block + 2 + 4;
  const CutBlocks cut = results.cut(step);
  out += coded(of_part * cut.parts.size());
  for (const auto& outline : cut.parts) out += coded(of_vertex * outline.size());
  return out;
}

/// Outlines of the parts of cut blocks, which belong to the step, and how they move.
Json parts(const CutBlocks& cut, const std::vector<double>& moved) {
  const auto [counts, vertices] = flat(cut.parts);
  return {{"blocks", integers({cut.part_block.begin(), cut.part_block.end()})},
          {"counts", base64_of(std::span<const std::uint16_t>(counts))},
          {"vertices", singles(vertices)},
          {"motion", motions(cut.parts, moved)}};
}

Json step_data(const ResultsReader& results, const ResultsMesh& mesh, int step) {
  Json out{{"step", step}, {"motion", motions(mesh.blocks, results.values(step, "displacement"))}};
  if (results.has(step, "stress")) out["stress"] = quantised(results.values(step, "stress"));
  const CutBlocks cut = results.cut(step);
  if (results.has(step, "segments/damage") || !cut.pieces.empty()) out["cracks"] = cracks(results, cut, step);
  if (!cut.parts.empty()) out["parts"] = parts(cut, results.values(step, "parts/displacement"));
  return out;
}

}  // namespace

std::vector<std::size_t> thinned(std::span<const std::size_t> sizes, std::size_t room, std::size_t must) {
  for (std::size_t count = sizes.size(); count > 0; --count) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < count; ++i)
      out.push_back(count == 1 ? sizes.size() - 1 : i * (sizes.size() - 1) / (count - 1));
    // The wanted one takes the place of its nearest neighbour, but of neither end.
    const bool is_missing = must < sizes.size() && std::ranges::find(out, must) == out.end();
    if (is_missing && out.size() > 2) {
      const auto distance = [&](std::size_t i) { return i > must ? i - must : must - i; };
      *std::ranges::min_element(out.begin() + 1, out.end() - 1, {}, distance) = must;
    }
    std::ranges::sort(out);
    out.erase(std::ranges::unique(out).begin(), out.end());
    const auto total = std::accumulate(out.begin(), out.end(), std::size_t{0},
                                       [&](std::size_t sum, std::size_t i) { return sum + sizes[i]; });
    if (total <= room) return out;
  }
  return {};
}

Json data_of_blocks(const ResultsReader& results, int peak_step, const Limits& limits) {
  const ResultsMesh mesh = results.mesh();
  Json out = geometry(results, mesh);
  const std::size_t geometry_size = out.dump().size();
  const std::size_t room = limits.fields > geometry_size ? limits.fields - geometry_size : 0;
  std::vector<std::size_t> sizes;
  for (const int step : results.steps()) sizes.push_back(size_of_step(results, step, mesh.blocks.size()));
  const auto peak =
      static_cast<std::size_t>(std::ranges::find(results.steps(), peak_step) - results.steps().begin());
  out["stored"] = results.steps().size();
  out["steps"] = Json::array();
  for (const std::size_t i : thinned(sizes, room, peak))
    out["steps"].push_back(step_data(results, mesh, results.steps()[i]));
  if (!results.steps().empty() && results.has(results.steps().front(), "stress"))
    out["stress_unit"] = results.unit(results.steps().front(), "stress");
  if (!out["steps"].empty()) return out;
  return {{"stored", results.steps().size()}, {"blocks", mesh.blocks.size()}, {"steps", Json::array()}};
}

}  // namespace dda::report
