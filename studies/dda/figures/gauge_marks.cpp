#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <set>

#include "framework/figure/style.hpp"
#include "models/body/place.hpp"
#include "studies/dda/figures/model_marks.hpp"
#include "studies/dda/figures/model_picture.hpp"

namespace dda {
namespace {

using svg::KeyEntry;
using svg::Mark;

/// What a gauge reads of one block, as a force dual to it.
struct ReadPoint {
  Vec2 at, force;
};

/// What a gauge reads, of the rows on blocks.
struct ReadRows {
  std::vector<ReadPoint> forces;
  double turn = 0;             ///< of rows without a resultant
  Vec3 strain = Vec3::Zero();  ///< likewise: on εx, εy, γxy
  Middle middle;               ///< of all blocks
  std::set<BlockId> blocks;

  Vec2 sum() const {
    Vec2 out = Vec2::Zero();
    for (const ReadPoint& reading : forces) out += reading.force;
    return out;
  }
  /// The two that are farthest apart, about.
  std::pair<Vec2, Vec2> ends() const {
    const auto farthest_from = [&](const Vec2& x) {
      return std::ranges::max_element(forces, {}, [&](const ReadPoint& r) { return (r.at - x).norm(); })->at;
    };
    const Vec2 end = farthest_from(forces.front().at);
    return {farthest_from(end), end};
  }
};

ReadRows rows_read(const Functional& gauge, const Body& body) {
  ReadRows out;
  for (const auto& [node, row] : gauge.rows) {
    if (node.value() >= body.assembly.num_blocks()) continue;  // a jump or a gradient belongs to its block
    const Block& block = body.block(node);
    out.middle.include(block);
    out.blocks.insert(node);
    const ActingForce acting = acts_at(row);
    if (!acting.force.isZero(0)) {
      out.forces.push_back({block.moments.centroid + acting.offset, acting.force});
      continue;
    }
    out.turn += row[2];
    out.strain += row.tail<3>();
  }
  return out;
}

/// The direction along which the strain dual to (e_x, e_y, e_xy) is largest.
Vec2 main_axis(const Vec3& e) {
  Eigen::Matrix2d tensor;
  tensor << e[0], e[2], e[2], e[1];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(tensor);
  const int largest = std::abs(axes.eigenvalues()[0]) > std::abs(axes.eigenvalues()[1]) ? 0 : 1;
  return axes.eigenvectors().col(largest);
}

class GaugeMarks {
 public:
  explicit GaugeMarks(const ModelDrawing& to) : to_(to), body_(to.simulation.body()) {}

  void add() {
    for (const NamedGauge& gauge : to_.simulation.gauges().gauges) add(gauge);
    add_keys();
  }

 private:
  void add(const NamedGauge& gauge) {
    const ReadRows readings = rows_read(gauge.functional, body_);
    const Node told = told_of(gauge.name);
    const auto [at, over] = std::pair{spots_of(told, "at"), spots_of(told, "over")};
    if (over.size() == 2) add_line(over[0], over[1]);
    const Vec2 middle = over.size() == 2 ? Vec2((over[0] + over[1]) / 2)
                        : at.size() == 1 ? at[0]
                                         : readings.middle.place();
    if (readings.blocks.empty()) return without_place_.push_back(gauge.name);
    if (gauge.dimension == dimension::none && !readings.forces.empty())
      return add_mark({Mark::turned, middle, Vec2::UnitX(), svg::blue, gauge.name});
    if (!readings.forces.empty())
      return over.size() == 2 ? add_mark({Mark::measured, middle, readings.sum(), svg::blue, gauge.name})
                              : add_forces(readings, gauge.name);
    if (readings.turn != 0) return add_mark({Mark::turned, middle, Vec2::UnitX(), svg::blue, gauge.name});
    const bool is_mean = at.empty() && readings.blocks.size() > 1;
    add_mark(
        {Mark::strained, middle, main_axis(readings.strain), svg::blue,
         is_mean ? fmt::format("{} (mean of {} blocks)", gauge.name, readings.blocks.size()) : gauge.name});
  }

  /// The gauge as the deck has it; null where none is of that name.
  Node told_of(const std::string& gauge) const {
    for (const auto& [name, choice] : to_.simulation.deck().gauge_names)
      if (name == gauge) return choice.echo();
    return {};
  }

  /// The points under a key of a gauge, none where there is no such key.
  std::vector<Vec2> spots_of(const Node& gauge, const char* key) const {
    const Node* found = gauge.find(key);
    if (found == nullptr || found->is_null()) return {};
    const bool is_list = found->is_sequence() && !found->items.empty() && key == std::string_view("over");
    std::vector<Vec2> out;
    if (!is_list) return {spot_of(*found)};
    for (const Node& spot : found->items) out.push_back(spot_of(spot));
    return out;
  }
  Vec2 spot_of(const Node& spot) const {
    if (spot.is_sequence()) return {std::stod(spot.items.at(0).text), std::stod(spot.items.at(1).text)};
    Spot named;
    named.name = spot.text;
    return locate(body_.assembly, named);
  }

  /// Of points each, of many along a line the line.
  void add_forces(const ReadRows& readings, const std::string& name) {
    constexpr std::size_t most_points = 4;  // two, each where two blocks meet
    if (readings.forces.size() <= most_points) {
      for (const auto& [at, force] : readings.forces) add_mark({Mark::measured, at, force, svg::blue, name});
      return;
    }
    const auto [start, end] = readings.ends();
    add_line(start, end);
    add_mark({Mark::measured, (start + end) / 2, readings.sum(), svg::blue, name});
  }

  void add_line(const Vec2& start, const Vec2& end) {
    to_.drawing.strokes.push_back({.start = start, .end = end, .colour = svg::blue});
  }
  void add_mark(svg::Symbol symbol) { to_.drawing.symbols.push_back(std::move(symbol)); }

  void add_keys() {
    const auto has = [&](Mark mark) {
      return std::ranges::any_of(to_.drawing.symbols, [&](const svg::Symbol& symbol) {
        return symbol.mark == mark && symbol.colour == svg::blue;
      });
    };
    auto& key = to_.drawing.key;
    if (has(Mark::measured)) key.push_back({KeyEntry::Kind::measured, svg::blue, "measured"});
    if (has(Mark::turned)) key.push_back({KeyEntry::Kind::turned, svg::blue, "rotation measured"});
    if (has(Mark::strained))
      key.push_back({KeyEntry::Kind::strained, svg::blue, "strain or stress measured"});
    if (!without_place_.empty())
      key.push_back({KeyEntry::Kind::measured, svg::blue,
                     fmt::format("of no one place: {}", fmt::join(without_place_, ", "))});
  }

  const ModelDrawing& to_;
  const Body& body_;
  std::vector<std::string> without_place_;
};

}  // namespace

void add_gauges(const ModelDrawing& to) { GaugeMarks(to).add(); }

}  // namespace dda
