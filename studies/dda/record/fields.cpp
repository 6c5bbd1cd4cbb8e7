#include "studies/dda/record/fields.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "models/body/motion.hpp"
#include "models/load/eigenstress.hpp"
#include "studies/dda/case/model_tables.hpp"

namespace dda {
namespace {

/// Each active point's equal share of its side, in the order in which they stand along it. Points of cuts come behind
/// those of sides and have none.
std::vector<std::array<Vec2, 2>> pieces_of_sides(const Assembly& assembly, const Equilibrium& equilibrium) {
  std::map<std::size_t, std::vector<std::size_t>> on_side;
  std::size_t num_points = 0;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
    if (equilibrium.point(p).cut) continue;
    on_side[equilibrium.point(p).side].push_back(p);
    ++num_points;
  }
  std::vector<std::array<Vec2, 2>> out(num_points);
  for (auto& [number, points] : on_side) {
    const Side& side = assembly.sides[number];
    const Vec2 along = side.end - side.start;
    std::ranges::sort(points, {}, [&](std::size_t p) { return along.dot(equilibrium.point(p).x); });
    const auto count = static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      out[points[i]] = {side.start + static_cast<double>(i) / count * along,
                        side.start + static_cast<double>(i + 1) / count * along};
  }
  return out;
}

void append(const Vec2& v, std::vector<double>& to) { to.insert(to.end(), {v.x(), v.y()}); }
void append(const Vec3& v, std::vector<double>& to) { to.insert(to.end(), v.begin(), v.end()); }

std::vector<double> flat(std::span<const Vec2> from) {
  std::vector<double> out;
  for (const Vec2& v : from) append(v, out);
  return out;
}

/// The larger and the smaller one.
std::array<StoredField, 2> principal(const StoredField& stress) {
  std::array<StoredField, 2> out{StoredField{"principal_stress_1", stress.unit, stress.place, 1, {}, ""},
                                 StoredField{"principal_stress_2", stress.unit, stress.place, 1, {}, ""}};
  for (std::size_t i = 0; i + 2 < stress.values.size(); i += 3) {
    const double xx = stress.values[i], yy = stress.values[i + 1], xy = stress.values[i + 2];
    const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
    out[0].values.push_back(mean + radius);
    out[1].values.push_back(mean - radius);
  }
  return out;
}

/// Of the parts what their blocks have.
StoredField of_parts(const StoredField& of_blocks, const std::vector<std::size_t>& block) {
  StoredField out = of_blocks;
  out.place = FieldPlace::part;
  out.values.clear();
  const auto width = static_cast<std::ptrdiff_t>(out.components);
  for (const std::size_t b : block) {
    const auto row = of_blocks.values.begin() + width * static_cast<std::ptrdiff_t>(b);
    out.values.insert(out.values.end(), row, row + width);
  }
  return out;
}

}  // namespace

std::vector<std::string> region_names(const Assembly& assembly) {
  std::vector<std::string> out;
  for (const auto& [name, material] : assembly.regions)
    out.push_back(name == material ? name : fmt::format("{} ({})", name, material));
  return out;
}

Fields::Fields(const Body& body, const ModelParameters& model, const Equilibrium& equilibrium,
               const Units& units)
    : body_(body),
      model_(model),
      equilibrium_(equilibrium),
      units_(units),
      segments_(pieces_of_sides(body.assembly, equilibrium)) {}

ResultsMesh Fields::mesh() const {
  ResultsMesh out{.blocks = {},
                  .block_region = {},
                  .region_names = region_names(body_.assembly),
                  .segments = segments_,
                  .length_unit = units_.length};
  for (const Block& block : body_.assembly.blocks) {
    out.blocks.push_back(outline(BlockId{out.blocks.size()}));
    out.block_region.push_back(block.region);
  }
  return out;
}

std::vector<Vec2> Fields::outline(BlockId block) const { return drawn(block, body_.block(block).outline); }

std::vector<Vec2> Fields::drawn(BlockId block, const Polygon& outline) const {
  if (!body_.gradient_of(block)) return outline.vertices;
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    out.push_back(outline.at(i));
    out.emplace_back((outline.at(i) + outline.at(i + 1)) / 2);
  }
  return out;
}

Vec2 Fields::displacement(BlockId block, const Vec2& x, std::span<const double> d) const {
  const auto of = [&](BlockId node) {
    return Eigen::Map<const Vec6>(d.data() + block_unknowns * node.value());
  };
  const Vec2 out = displacement_rows(x - body_.block(block).moments.centroid) * of(block);
  const auto gradient = body_.gradient_of(block);
  return gradient ? Vec2(out + gradient_motion(body_, block, x) * of(*gradient)) : out;
}

Vec2 Fields::displacement_behind(const InterfacePoint& point, const Vec2& x,
                                 std::span<const double> d) const {
  const Vec2 out = displacement(point.second, x, d);
  return point.is_mirror() ? Vec2(out - 2 * point.normal.dot(out) * point.normal) : out;
}

Vec2 Fields::displacement_by(std::span<const JumpId> jumps, const Vec2& x, std::span<const double> d) const {
  Vec2 out = Vec2::Zero();
  for (const JumpId jump : jumps) {
    const NodeMotion motion = motion_of(body_, jump, x);
    out += motion.rows * Eigen::Map<const Vec6>(d.data() + block_unknowns * motion.node.value());
  }
  return out;
}

Vec2 Fields::displacement_between(std::size_t p, const Vec2& x, std::span<const double> d) const {
  const InterfacePoint& point = equilibrium_.point(p);
  Vec2 sum = displacement(point.first, x, d) + displacement_behind(point, x, d);
  if (!body_.cracks) return sum / 2;
  constexpr double aside = 1e-6;  // of the size of a block: inside of the part that lies there
  const Vec2 off = aside * body_.cracks->block_size() * point.normal;
  sum += displacement_by(body_.cracks->jumps_at(point.first, x - off), x, d);
  sum += displacement_by(body_.cracks->jumps_at(point.second, x + off), x, d);
  return sum / 2;
}

std::vector<std::vector<Fields::MovedVertex>> Fields::moved_parts(BlockId block,
                                                                  std::span<const double> d) const {
  std::vector<std::vector<MovedVertex>> out;
  const auto add = [&](const Polygon& outline, std::span<const JumpId> jumps) {
    out.emplace_back();
    for (const Vec2& x : drawn(block, outline))
      out.back().push_back({x, displacement(block, x, d) + displacement_by(jumps, x, d)});
  };
  if (body_.cracks)
    for (const Part& part : body_.cracks->parts(block)) add(part.outline, part.jumps);
  if (out.empty()) add(body_.block(block).outline, {});
  return out;
}

/// Of a cut each point has the half, or the third, in which it stands.
std::array<Vec2, 2> Fields::segment(std::size_t p) const {
  const InterfacePoint& point = equilibrium_.point(p);
  if (!point.cut) return segments_[p];
  const Cut& cut = body_.cracks->cuts()[*point.cut];
  const auto stands_beside = [&](std::size_t other) { return equilibrium_.point(other).cut == point.cut; };
  std::size_t first = p, last = p;
  while (first > 0 && stands_beside(first - 1)) --first;
  while (last + 1 < equilibrium_.num_active() && stands_beside(last + 1)) ++last;
  const auto count = static_cast<double>(last - first + 1);
  const auto at = [&](std::size_t i) -> Vec2 {
    return ((count - static_cast<double>(i)) * cut.start + static_cast<double>(i) * cut.end) / count;
  };
  return {at(p - first), at(p - first + 1)};
}

Fields::Interface Fields::interface_at(const StoredState& at) const {
  const std::size_t n = equilibrium_.num_active();
  std::vector<Vec2> q(n);
  equilibrium_.gather(equilibrium_.stages().back(), at.state.d, at.state.load_factor, components(q));
  Interface out{std::vector<Vec2>(n), std::vector<Vec2>(n), std::vector<Vec2>(n), std::vector<double>(n)};
  for (std::size_t p = 0; p < n; ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    if (!at.state.multipliers.empty()) q[p] += at.state.multipliers[p];
    out.traction[p] = point.law->respond(q[p], at.history[p], point.stiffness).traction;
    out.opening[p] = q[p] - out.traction[p].cwiseQuotient(point.trial_stiffness());
    const Vec2 jump =
        displacement_behind(point, point.x, at.state.d) - displacement(point.first, point.x, at.state.d);
    out.jump[p] = {point.normal.dot(jump), cross(point.normal, jump)};
    for (const JumpRows& cut : point.jumps)
      out.jump[p] += cut.rows * Eigen::Map<const Vec6>(at.state.d.data() + block_unknowns * cut.node.value());
    out.damage[p] = point.law->damage(at.history[p], point.stiffness);
  }
  return out;
}

/// Of the vertices of all blocks, and of the parts of those that are cut.
void Fields::add_motion(const std::string& name, const std::string& unit, std::span<const double> d,
                        Snapshot& out) const {
  StoredField whole{name, unit, FieldPlace::block_vertex, 2, {}, "x y z"};
  StoredField parts{name, unit, FieldPlace::part_vertex, 2, {}, "x y z"};
  for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
    const BlockId block(b);
    for (const Vec2& x : outline(block)) {
      Vec2 u = displacement(block, x, d);
      if (body_.cracks) u += displacement_by(body_.cracks->jumps_at(block, x), x, d);
      append(u, whole.values);
    }
    if (!body_.cracks || body_.cracks->parts(block).empty()) continue;
    for (const auto& part : moved_parts(block, d))
      for (const MovedVertex& vertex : part) append(vertex.u, parts.values);
  }
  out.fields.push_back(std::move(whole));
  if (!parts.values.empty()) out.fields.push_back(std::move(parts));
}

/// Of blocks of second order; zero of the others.
void Fields::add_gradients(const State& state, Snapshot& out) const {
  StoredField gradient{"strain_gradient",
                       label(dimension::curvature, units_),
                       FieldPlace::block,
                       block_unknowns,
                       {},
                       "xx_x xx_y yy_x yy_y 2xy_x 2xy_y"};
  for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
    Vec6 row = Vec6::Zero();
    if (const auto node = body_.gradient_of(BlockId(b)))
      row = Eigen::Map<const Vec6>(state.d.data() + block_unknowns * node->value()) / body_.size(BlockId(b));
    gradient.values.insert(gradient.values.end(), row.begin(), row.end());
  }
  if (!out.cut.parts.empty()) out.fields.push_back(of_parts(gradient, out.cut.part_block));
  out.fields.push_back(std::move(gradient));
}

void Fields::add_stress_at_vertices(const BlockFields& means, const State& state, Snapshot& out) const {
  StoredField stress{"stress_at_vertices", means.stress.unit, FieldPlace::block_vertex, 3, {}, stress_labels};
  StoredField zz{out_of_plane_of(stress.name), stress.unit, FieldPlace::block_vertex, 1, {}, ""};
  const Loading& loading = equilibrium_.stages().back();
  for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
    const BlockId block(b);
    const Material& material = body_.material(block);
    const Vec3 mean = Eigen::Map<const Vec3>(means.stress.values.data() + 3 * b);
    for (const Vec2& x : outline(block)) {
      const Vec3 by_strain = stress_beside_mean(body_, block, x, state.d.all());
      Vec3 beside = by_strain;
      double out_of_plane = material.out_of_plane().dot(material.stiffness().inverse() * by_strain);
      for (const auto& [place, share] : eigenstress_beside_mean(body_, block, x)) {
        beside += share * loading.initial_stress(place, state.load_factor);
        out_of_plane += share * loading.out_of_plane(place, state.load_factor);
      }
      append(Vec3(mean + beside), stress.values);
      zz.values.push_back(means.out_of_plane.values[b] + out_of_plane);
    }
  }
  if (model_.plane == Plane::strain) out.fields.push_back(std::move(zz));
  out.fields.push_back(std::move(stress));
}

Fields::BlockFields Fields::block_fields(const State& state) const {
  const std::string unit = label(dimension::stress, units_);
  const bool is_held = model_.plane == Plane::strain;
  BlockFields out{{"strain", "", FieldPlace::block, 3, {}, strain_labels},
                  {"stress", unit, FieldPlace::block, 3, {}, stress_labels},
                  {is_held ? "stress_zz" : "strain_zz", is_held ? unit : "", FieldPlace::block, 1, {}, ""}};
  const Loading& loading = equilibrium_.stages().back();
  for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
    const Material& material = body_.material(BlockId(b));
    const Vec3 strain = Eigen::Map<const Vec3>(state.d.data() + block_unknowns * b + 3);
    append(strain, out.strain.values);
    append(Vec3(material.stiffness() * strain + loading.initial_stress(b, state.load_factor)),
           out.stress.values);
    out.out_of_plane.values.push_back(material.out_of_plane().dot(strain) +
                                      loading.out_of_plane(b, state.load_factor));
  }
  return out;
}

void Fields::add_blocks(const State& state, Snapshot& out) const {
  BlockFields of_blocks = block_fields(state);
  add_motion("displacement", units_.length, state.d, out);
  if (body_.num_gradients() > 0) {
    add_gradients(state, out);
    add_stress_at_vertices(of_blocks, state, out);
  }
  auto [larger, smaller] = principal(of_blocks.stress);
  // Ahead of the tensor whose view has it.
  for (StoredField* field :
       {&of_blocks.out_of_plane, &of_blocks.strain, &of_blocks.stress, &larger, &smaller}) {
    if (!out.cut.parts.empty()) out.fields.push_back(of_parts(*field, out.cut.part_block));
    out.fields.push_back(std::move(*field));
  }
}

/// A shape has no size of its own: its largest displacement becomes 1.
std::vector<double> Fields::mode(const std::vector<double>& shape) const {
  double largest = 0;
  for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b)
    for (const auto& part : moved_parts(BlockId(b), shape))
      for (const MovedVertex& vertex : part) largest = std::max(largest, vertex.u.norm());
  std::vector<double> out = shape;
  if (largest > 0)
    for (double& value : out) value /= largest;
  return out;
}

void Fields::add_points(const Interface& all, const Points& points, const StoredState& at,
                        Snapshot& out) const {
  if (points.begin == points.end) return;
  const auto of = [&](const auto& values) {
    return std::span(values).subspan(points.begin, points.end - points.begin);
  };
  const auto damage = of(all.damage);
  const std::string stress = label(dimension::stress, units_);
  // The mean of both faces, so that a crack is drawn between them.
  StoredField moved{"displacement", units_.length, points.place_of_ends, 2, {}, "x y z"};
  StoredField strength{"strength_factor", "", points.place, 1, {}, ""};
  StoredField water{"water_pressure", stress, points.place, 1, {}, ""};
  for (std::size_t p = points.begin; p < points.end; ++p) {
    for (const Vec2& x : segment(p)) append(displacement_between(p, x, at.state.d), moved.values);
    const InterfacePoint& point = equilibrium_.point(p);
    strength.values.push_back(point.strength_factor);
    water.values.push_back(point.law->water_pressure(at.history[p], point.stiffness));
  }
  out.fields.push_back(std::move(moved));
  out.fields.push_back({"opening", units_.length, points.place, 2, flat(of(all.opening)), "n s"});
  out.fields.push_back({"jump", units_.length, points.place, 2, flat(of(all.jump)), "n s"});
  out.fields.push_back({"traction", stress, points.place, 2, flat(of(all.traction)), "n s"});
  out.fields.push_back({"damage", "", points.place, 1, {damage.begin(), damage.end()}, ""});
  if (equilibrium_.interfaces().has_fields) out.fields.push_back(std::move(strength));
  if (equilibrium_.interfaces().has_water) out.fields.push_back(std::move(water));
}

CutBlocks Fields::cut_blocks() const {
  CutBlocks out;
  if (!body_.cracks || body_.cracks->empty()) return out;
  for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b)
    for (const Part& part : body_.cracks->parts(BlockId(b))) {
      out.parts.push_back(drawn(BlockId(b), part.outline));
      out.part_block.push_back(b);
    }
  for (std::size_t p = segments_.size(); p < equilibrium_.num_active(); ++p) out.pieces.push_back(segment(p));
  out.tables = cut_tables(body_, model_, equilibrium_);
  return out;
}

/// That of the present stage, and where several are followed those of each: where it is held, and 0 where it is to come.
std::map<std::string, double> Fields::load_factors(double now) const {
  std::map<std::string, double> out{{"load_factor", now}};
  const std::vector<std::size_t> stages = model_.followed_stages();
  const std::vector<double>& held = equilibrium_.held_load_factors();
  for (std::size_t i = 0; stages.size() > 1 && i < stages.size(); ++i)
    out[fmt::format("load_factor_{}", stages[i] + 1)] = i < held.size()    ? held[i]
                                                        : i == held.size() ? now
                                                                           : 0;
  return out;
}

Snapshot Fields::snapshot(const StoredState& at) const {
  Snapshot out{.step = at.step,
               .time = static_cast<double>(at.step),
               .numbers = load_factors(at.state.load_factor),
               .fields = {},
               .cut = cut_blocks()};
  const StageHistory& stages = equilibrium_.history();
  for (const auto& [name, numbers] :
       {std::pair{"supports/rest", &stages.rest}, {"supports/borne", &stages.borne}})
    if (!numbers->empty()) out.tables.push_back({name, *numbers, {}, {}, 1});
  add_blocks(at.state, out);
  for (std::size_t i = 0; i < at.modes.size(); ++i)
    add_motion("mode_" + std::to_string(i + 1), "", mode(at.modes[i]), out);
  const Interface all = interface_at(at);
  add_points(all, {0, segments_.size(), FieldPlace::segment, FieldPlace::segment_end}, at, out);
  add_points(all, {segments_.size(), equilibrium_.num_active(), FieldPlace::crack, FieldPlace::crack_end}, at,
             out);
  return out;
}

}  // namespace dda
