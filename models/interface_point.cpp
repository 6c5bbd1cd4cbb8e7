#include "models/interface_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_set>

#include "models/body/motion.hpp"
#include "models/interface/scaled_law.hpp"
#include "models/interface/water_filled_law.hpp"
#include "models/interface_book.hpp"
#include "models/jump_rows.hpp"
#include "models/kinematics/second_order.hpp"
#include "models/locked_joints.hpp"
#include "models/point_rule.hpp"
#include "models/treatment/mirrored.hpp"
#include "models/treatment/trace_constant.hpp"

namespace dda {
namespace {

/// k is kept this far above the steepest softening slope: the trial law then falls at most three times as
/// steeply.
constexpr double comfortable_margin = 1.5;
/// Below this the trial law has no usable softening branch left.
constexpr double smallest_margin = 1.02;

/// Finds the interface of a side and makes its points.
class PointMaker {
 public:
  PointMaker(const Body& body, const ModelParameters& model, Findings& findings)
      : body_(body), findings_(findings), book_(body, model, findings), faces_(body.assembly.num_blocks()) {}

  /// Of some sides, in their order, and of all cuts.
  InterfaceSet make(std::span<const std::size_t> of) {
    InterfaceSet out;
    out.points.reserve(2 * of.size());  // mostly two on a side
    for (const std::size_t s : of) add_side(s, book_.of_side(body_.assembly.sides[s]), out);
    add_cuts(out);
    const auto middle =
        std::ranges::stable_partition(out.points, [](const auto& p) { return p.is_active(); });
    out.num_active = static_cast<std::size_t>(middle.begin() - out.points.begin());
    for (Interface& interface : book_.interfaces()) {
      out.has_fields |= interface.field.has_value();
      out.has_water |= interface.water.has_value();
      out.names.push_back(interface.name);
      out.laws.push_back(interface.law);
      report(interface, out.notices);
    }
    out.laws.push_back(book_.bond().law);
    return out;
  }

 private:
  /// What a place of an interface is made of.
  struct Local {
    double factor = 1;  ///< of its random field
    std::shared_ptr<const InterfaceLaw> law;
  };
  /// Strengths are f |n·m| times those of the law: f of the random field, n the normal of the plane in which the
  /// structure is known to crack, m that of the side.
  static Local local_law(const Interface& interface, const Vec2& x, const Vec2& normal) {
    if (!interface.is_local()) return {1, interface.law};
    constexpr double least = 0.3;
    const double f = interface.field ? interface.field->factor(x) : 1,
                 opening = std::pow(f, interface.energy_exponent - 1);
    const double share =
        interface.crack_normal ? std::max(least, std::abs(interface.crack_normal->dot(normal))) : 1;
    std::shared_ptr<const InterfaceLaw> law = interface.law;
    if (interface.field || interface.crack_normal)
      law = std::make_shared<const ScaledLaw>(law, f * share, opening);
    return {f, with_water(interface, x, std::move(law))};
  }
  static std::shared_ptr<const InterfaceLaw> with_water(const Interface& interface, const Vec2& x,
                                                        std::shared_ptr<const InterfaceLaw> law) {
    const double pressure = interface.water ? interface.water->pressure(x) : 0;
    if (pressure <= 0) return law;
    return std::make_shared<const WaterFilledLaw>(std::move(law), pressure, *interface.water->opening);
  }

  const BlockFace& face_of(BlockId id) {
    std::optional<BlockFace>& out = faces_[id.value()];
    if (out) return *out;
    const Mat3 c = body_.material(id).stiffness();
    const double trace = body_.gradient_of(id) ? second_order_trace_constant(body_.block(id), c)
                                               : trace_constant(body_.block(id), c);
    return out.emplace(c, trace, body_.material(id).modulus());
  }

  /// The points of an interface on a side of these blocks.
  PointsOfSide points_of(Interface& interface, const Side& side) const {
    if (!body_.gradient_of(side.first) && !body_.gradient_of(side.second))
      return points_of_side(interface.points);
    interface.misses_linear_stress |= !integrates_linear_stress(interface.second_order_points);
    return interface.second_order_points == PointRule::gauss_2 ? two_gauss_points() : three_gauss_points();
  }

  SideFaces faces_of(const Side& side) {
    const Vec2 edge = side.end - side.start;
    const Vec2 normal = Vec2(edge.y(), -edge.x()) / edge.norm(),
               &first = body_.block(side.first).moments.centroid;
    const double distance = side.is_mirror() ? 2 * std::abs(normal.dot(side.start - first))
                                             : (body_.block(side.second).moments.centroid - first).norm();
    return {face_of(side.first), face_of(side.second), distance, edge.norm(), normal};
  }

  /// Of each point of a straight line.
  static std::vector<Local> laws_along(const Interface& interface, const PointLine& line) {
    std::vector<Local> out;
    for (const auto& [xi, share] : line.points)
      out.push_back(local_law(interface, line.start + xi * (line.end - line.start), line.normal));
    return out;
  }

  void add_side(std::size_t index, Interface& interface, InterfaceSet& out) {
    const Side& side = body_.assembly.sides[index];
    const bool remembers =
        interface.law->can_crack() || interface.treatment->multiplier() != Multiplier::none;
    if (remembers || !body_.cracks || !body_.cracks->is_touched(index))
      return add_points({index, side.start, side.end, {}}, interface, out);
    for (const SidePiece& piece : body_.cracks->pieces_of_side(index))
      if (!piece.cut) add_points({index, piece.start, piece.end, {}}, interface, out);
  }

  /// A piece of a side, or all of it.
  struct Stretch {
    std::size_t side;
    Vec2 start, end;
    std::optional<std::size_t> cut;
  };

  void add_points(const Stretch& stretch, Interface& interface, InterfaceSet& out) {
    const Side& side = body_.assembly.sides[stretch.side];
    const Vec2 edge = stretch.end - stretch.start;
    const SideFaces faces = faces_of(side);
    const PointLine line{stretch.start, stretch.end, faces.normal, points_of(interface, side)};
    std::vector<Local> laws = laws_along(interface, line);
    const double k = stiffness(interface, laws, faces, side);
    const Treatment& treatment = *interface.treatment;
    JumpsOfPoints jumps = jumps_along_side(body_, stretch.side, line);
    const BlockId node{body_.num_nodes() + out.num_nodes};
    if (treatment.multiplier() == Multiplier::unknown) ++out.num_nodes;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const auto& [xi, share] = line.points[i];
      const bool is_separate = laws[i].law->contact({}, k).has_value();
      InterfacePoint point{.first = side.first,
                           .second = side.second,
                           .x = stretch.start + xi * edge,
                           .normal = faces.normal,
                           .weight = share * edge.norm() * body_.thickness / (side.is_mirror() ? 2 : 1),
                           .stiffness = k,
                           .law = laws[i].law.get(),
                           .interface = interface.index,
                           .side = stretch.side,
                           .cut = stretch.cut,
                           .is_awaited = stretch.cut && body_.cracks->cuts()[*stretch.cut].is_provisional,
                           .rows = {},
                           .multiplier = treatment.multiplier(),
                           .node = node,
                           .column = static_cast<int>(2 * i),
                           .perturbation = treatment.perturbation(is_separate),
                           .physical_stiffness = physical_stiffness(treatment, faces, k, is_separate),
                           .spring_unit = spring_unit(faces),
                           .strength_factor = laws[i].factor};
      add_rows(point, treatment, faces);
      point.jumps = std::move(jumps[i]);
      out.points.push_back(std::move(point));
      if (interface.is_local()) out.laws.push_back(std::move(laws[i].law));
    }
  }

  void add_rows(InterfacePoint& point, const Treatment& treatment, const SideFaces& faces) const {
    const Vec2 stiffness = point.trial_stiffness();
    const auto of_block = [&](BlockId id) {
      return MotionRows{displacement_rows(point.x - body_.block(id).moments.centroid), strain_rows()};
    };
    const auto behind = [&](const MotionRows& rows) {
      return point.is_mirror() ? mirrored(rows, faces.normal) : rows;
    };
    point.rows = treatment.rows(faces, of_block(point.first), behind(of_block(point.second)), stiffness);
    const auto first = body_.gradient_of(point.first), second = body_.gradient_of(point.second);
    if (!first && !second) return;
    const PointRows rows = treatment.rows(faces, gradient_rows(point.first, point.x),
                                          behind(gradient_rows(point.second, point.x)), stiffness);
    if (first) point.gradients.push_back({*first, rows.first, rows.first_stress});
    if (second) point.gradients.push_back({*second, rows.second, rows.second_stress});
  }

  /// Of the gradient of a block's strain; none of a block of first order.
  MotionRows gradient_rows(BlockId id, const Vec2& x) const {
    if (!body_.gradient_of(id)) return {};
    return {gradient_motion(body_, id, x), gradient_strain(body_, id, x)};
  }

  void add_cuts(InterfaceSet& out) {
    if (!body_.cracks) return;
    for (std::size_t c = 0; c < body_.cracks->cuts().size(); ++c) {
      const Cut& cut = body_.cracks->cuts()[c];
      const ThroughBlocks& through = *book_.through(body_.block(cut.block).region);
      if (cut.side)
        add_points({*cut.side, cut.start, cut.end, c}, book_.law_of(through), out);
      else
        add_cut(c, through, out);
    }
  }

  void add_cut(std::size_t index, const ThroughBlocks& through, InterfaceSet& out) {
    const Cut& cut = body_.cracks->cuts()[index];
    Interface& interface = book_.law_of(through);
    const PointLine line{cut.start, cut.end, cut.normal(),
                         points_of(interface, {cut.block, cut.block, cut.start, cut.end, {}})};
    std::vector<Local> laws = laws_along(interface, line);
    const BlockFace& of_block = face_of(cut.block);
    const double size = std::sqrt(body_.block(cut.block).moments.area);
    const SideFaces faces{of_block, of_block, size, cut.length(), cut.normal()};
    const double k = cut_stiffness(index, through, laws, faces);
    JumpsOfPoints jumps = jumps_along_cut(body_, cut, line);
    for (std::size_t i = 0; i < laws.size(); ++i) {
      const auto [xi, share] = line.points[i];
      InterfacePoint point{.first = cut.block,
                           .second = cut.block,
                           .x = cut.start + xi * (cut.end - cut.start),
                           .normal = cut.normal(),
                           .weight = share * cut.length() * body_.thickness,
                           .stiffness = k,
                           .law = laws[i].law.get(),
                           .interface = interface.index,
                           .side = body_.assembly.sides.size() + index,
                           .cut = index,
                           .is_awaited = cut.is_provisional,
                           .rows = {},
                           .physical_stiffness = k,
                           .spring_unit = spring_unit(faces),
                           .strength_factor = laws[i].factor};
      point.jumps = std::move(jumps[i]);
      add_stress_rows(point, of_block.stiffness);
      out.points.push_back(std::move(point));
      if (interface.is_local()) out.laws.push_back(std::move(laws[i].law));
    }
  }

  /// On a cut q = g + P⁻¹ σn, σ that of the block.
  void add_stress_rows(InterfacePoint& point, const Mat3& stiffness) const {
    const Vec2 compliance = point.trial_stiffness().cwiseInverse();
    const Eigen::Matrix<double, 2, 3> traction = traction_rows(point.normal) * stiffness;
    point.rows.first_stress = traction * strain_rows();
    point.rows.first = compliance.asDiagonal() * point.rows.first_stress;
    point.rows.second.setZero();
    if (const auto node = body_.gradient_of(point.first)) {
      const Mat26 stress = traction * gradient_strain(body_, point.first, point.x);
      point.gradients.push_back({*node, compliance.asDiagonal() * stress, stress});
    }
  }

  double line_trace_of(const Cut& cut, const Mat3& stiffness) const {
    const Block& block = body_.block(cut.block);
    return body_.gradient_of(cut.block)
               ? second_order_line_trace_constant(cut.start, cut.end, block, stiffness)
               : line_trace_constant(cut.length(), cut.normal(), block.moments.area, stiffness);
  }

  /// k of a cut. What consistent sides subtract takes up to 1/(2α) of a block's strain energy and a cut c_Γ/k of it;
  /// the m-th cut of a block is given 1/(m (m + 1)) of the rest, of which no number of cuts takes all. The jump of a
  /// cut with its three rigid modes cannot lock, so that k may be as large as one likes.
  double cut_stiffness(std::size_t index, const ThroughBlocks& through, const std::vector<Local>& laws,
                       const SideFaces& faces) {
    constexpr double margin = 1.2;
    const Interface& interface = book_.law_of(through);
    const auto& cuts = body_.cracks->cuts();
    const Cut& cut = cuts[index];
    const auto m = static_cast<double>(
        1 + std::count_if(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(index),
                          [&](const Cut& other) { return !other.side && other.block == cut.block; }));
    const double of_sides = interface.treatment->stiffness(faces), alpha = of_sides / faces.first.trace;
    const double left = 1 - 1 / (2 * alpha);
    if (left <= 0) findings_.add(interface.where, "cracks through blocks need `alpha` above 0.5");
    const double line = line_trace_of(cut, faces.first.stiffness);
    const double beta = interface.law->shear_weight();
    double slope = 0;
    for (const Local& local : laws) slope = std::max(slope, local.law->steepest_slope());
    return std::max({margin * m * (m + 1) * line / left / std::min(1.0, beta * beta),
                     through.stiffness * of_sides / std::min(1.0, beta * beta), comfortable_margin * slope});
  }

  /// p̄, at most what the multipliers' own compliance δ/((1 + δ) k) leaves of it where bodies only touch.
  static double physical_stiffness(const Treatment& treatment, const SideFaces& faces, double k,
                                   bool is_separate) {
    const double own = treatment.physical_stiffness(faces),
                 perturbation = treatment.perturbation(is_separate);
    const double largest = is_separate && perturbation > 0 ? k * (1 + perturbation) / perturbation
                                                           : std::numeric_limits<double>::infinity();
    return std::max(k, std::min(own, largest));
  }

  /// The treatment's k, raised where a steep law needs it.
  double stiffness(Interface& interface, const std::vector<Local>& laws, const SideFaces& faces,
                   const Side& side) {
    const double beta = interface.law->shear_weight();
    const double own = interface.treatment->stiffness(faces) / std::min(1.0, beta * beta);
    double slope = 0;
    for (const Local& local : laws) slope = std::max(slope, local.law->steepest_slope());
    if (own >= comfortable_margin * slope) return own;
    const double largest = interface.treatment->largest_stiffness(faces) / std::min(1.0, beta * beta);
    const double raised = std::clamp(comfortable_margin * slope, own, std::max(own, largest));
    note(interface, raised / slope, raised > own, std::sqrt(body_.block(side.first).moments.area));
    return raised;
  }

  static void note(Interface& interface, double ratio, bool raised, double size) {
    if (ratio < smallest_margin)
      ++interface.refused;
    else if (raised)
      ++interface.raised;
    if (ratio >= interface.worst_ratio) return;
    interface.worst_ratio = ratio;
    interface.worst_size = size;
  }

  void report(const Interface& interface, std::vector<std::string>& notices) {
    if (interface.refused > 0)
      findings_.add(
          interface.where,
          fmt::format("the blocks are too large for the softening of interface '{}' ({} sides): with blocks "
                      "of size {:.3g} the joint reaches {:.3g} times the softening slope and needs {:g}; use "
                      "blocks below {:.3g}, or a larger fracture energy{}",
                      interface.name, interface.refused, interface.worst_size, interface.worst_ratio,
                      smallest_margin, interface.worst_size * interface.worst_ratio / comfortable_margin,
                      interface.water ? ", or a larger `opening` of its `water`" : ""));
    if (interface.misses_linear_stress)
      findings_.add(
          interface.where,
          fmt::format(
              "blocks of second order beside interface '{}' need Gauss points: `points: gauss` (three "
              "on a side) or `gauss_2`. Their stress is linear along a side, which the ends of sides "
              "overrate "
              "up to threefold and midpoints do not feel; points at ends need blocks of first order on both "
              "sides",
              interface.name));
    if (interface.raised > 0)
      notices.push_back(
          fmt::format("interface '{}': joint stiffness raised on {} sides, its softening is steep for "
                      "blocks of this size",
                      interface.name, interface.raised));
  }

  const Body& body_;
  Findings& findings_;
  InterfaceBook book_;
  std::vector<std::optional<BlockFace>> faces_;  ///< of blocks that have been asked for
};

/// The order in which the points of a set stand.
bool comes_before(const InterfacePoint& a, const InterfacePoint& b) {
  const auto place = [](const InterfacePoint& p) {
    return std::tuple(!p.is_active(), p.cut.has_value(), p.cut.value_or(p.side));
  };
  return place(a) < place(b);
}

}  // namespace

InterfaceSet make_interface_points(const Body& body, const ModelParameters& model, Findings& findings) {
  std::vector<std::size_t> all(body.assembly.sides.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  InterfaceSet out = PointMaker(body, model, findings).make(all);
  if (body.cracks) out.touched = body.cracks->touched_sides();
  out.locked = locked_joints(body, out);
  std::ranges::copy(out.locked, std::back_inserter(out.notices));
  return out;
}

void remake_interface_points(const Body& body, const ModelParameters& model, Findings& findings,
                             InterfaceSet& set) {
  std::vector<std::size_t> touched, changed;
  if (body.cracks) touched = body.cracks->touched_sides();
  std::ranges::set_union(touched, set.touched, std::back_inserter(changed));
  InterfaceSet made = PointMaker(body, model, findings).make(changed);
  if (!findings.empty()) return;
  std::erase_if(set.points, [&](const InterfacePoint& p) {
    return p.cut.has_value() || std::ranges::binary_search(changed, p.side);
  });
  const auto middle = set.points.insert(set.points.end(), std::make_move_iterator(made.points.begin()),
                                        std::make_move_iterator(made.points.end()));
  std::inplace_merge(set.points.begin(), middle, set.points.end(), comes_before);
  set.num_active = static_cast<std::size_t>(
      std::ranges::partition_point(set.points, &InterfacePoint::is_active) - set.points.begin());
  std::ranges::move(made.laws, std::back_inserter(set.laws));
  std::unordered_set<const InterfaceLaw*> used;
  for (const InterfacePoint& point : set.points) used.insert(point.law);
  std::erase_if(set.laws, [&](const auto& law) { return !used.contains(law.get()); });
  set.touched = std::move(touched);
}

}  // namespace dda
