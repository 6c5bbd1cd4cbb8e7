#include "models/equilibrium/support.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>

#include "framework/base/suggestion.hpp"
#include "meshing/quality.hpp"
#include "models/body/motion.hpp"

namespace dda {
namespace {

using Directions = std::vector<std::pair<std::string, Vec2>>;

/// Name suffix and direction of each translation that is held.
Directions directions(const SupportParameters& p, const Vec2& normal) {
  if (p.direction) return {{"", p.direction->normalized()}};
  switch (*p.fix) {
    case Fix::x:
      return {{"", Vec2::UnitX()}};
    case Fix::y:
      return {{"", Vec2::UnitY()}};
    case Fix::xy:
      return {{".x", Vec2::UnitX()}, {".y", Vec2::UnitY()}};
    case Fix::normal:
      return {{"", normal}};
    case Fix::rotation:
    case Fix::straight:
      break;
  }
  return {};
}

/// Adds the springs of one support.
class SupportMaker {
 public:
  SupportMaker(const Body& body, double stiffness, std::vector<Spring>& out)
      : body_(body), stiffness_(stiffness), out_(out) {}

  void add(const std::string& name, const SupportParameters& p) {
    const std::size_t first = out_.size();
    add_springs(name, p);
    for (std::size_t i = first; i < out_.size(); ++i) out_[i].support = name;
  }

 private:
  void add_springs(const std::string& name, const SupportParameters& p) {
    const double stiffness = p.stiffness.value_or(stiffness_);
    if (p.at)
      add_at(name, p, stiffness);
    else if (p.over)
      add_over(name, p, stiffness);
    else
      add_along(name, p, stiffness);
  }

  void add_at(const std::string& name, const SupportParameters& p, double stiffness) {
    const Vec2 at = locate(body_.assembly, *p.at);
    if (p.fix == Fix::rotation)
      for (const BlockId id : blocks_of(body_.assembly, p, p.where))
        add_rotation(name, {id, at, {}}, stiffness);
    for (const auto& [suffix, direction] : directions(p, Vec2::Zero()))
      for (const BlockId id : blocks_of(body_.assembly, p, p.where))
        add_spring(name + suffix, {id, at, direction}, stiffness);
  }

  /// One spring on the mean of the patch: its force is an even traction. That on the rotation is as stiff as
  /// springs p̄/L along the patch, ∫ p̄/L s² ds = p̄ L²/12; those of what is to stay straight are such springs.
  void add_over(const std::string& name, const SupportParameters& p, double stiffness) {
    const auto points = patch_points(body_, p, p.where);
    const double length =
        (locate(body_.assembly, p.over->back()) - locate(body_.assembly, p.over->front())).norm();
    if (p.fix == Fix::rotation)
      out_.push_back({.reaction = name,
                      .displacement = rotation_over(body_, p, p.where),
                      .stiffness = stiffness * length * length / 12,
                      .turns = true});
    if (p.fix == Fix::straight)
      for (auto& [departure, part] : departures_over(body_, p, p.where))
        out_.push_back({"", std::move(departure), stiffness * part / length});
    for (const auto& [suffix, direction] : directions(p, points.front().normal))
      out_.push_back({name + suffix, displacement_at(body_, p, direction, p.where), stiffness});
  }

  /// Springs along a boundary are as stiff as the length they stand for, so that a uniform traction moves it
  /// evenly.
  void add_along(const std::string& name, const SupportParameters& p, double stiffness) {
    const auto points = held_points(body_, *p.boundary, p.where);
    double length = 0;
    for (const BoundaryPoint& point : points) length += point.length;
    const double per_length = stiffness * static_cast<double>(points.size()) / length;
    for (const BoundaryPoint& point : points) {
      if (p.fix == Fix::rotation) add_rotation(name, {point.block, point.x, {}}, stiffness);
      for (const auto& [suffix, direction] : directions(p, point.normal))
        add_spring(name + suffix, {point.block, point.x, direction}, per_length * point.length);
    }
  }

  struct Held {
    BlockId block;
    Vec2 x, direction;
  };
  void add_spring(const std::string& name, const Held& held, double stiffness) {
    Functional displacement;
    for (const auto& [node, rows] : motions_at(body_, held.block, held.x))
      displacement.rows.emplace_back(node, rows.transpose() * held.direction);
    out_.push_back({name, std::move(displacement), stiffness});
  }
  /// A rotational spring p̄ A on r0, and on what turns beside it.
  void add_rotation(const std::string& name, const Held& held, double stiffness) {
    out_.push_back({.reaction = name,
                    .displacement = {.rows = rotations_at(body_, held.block, held.x)},
                    .stiffness = stiffness * body_.block(held.block).moments.area,
                    .turns = true});
  }

  const Body& body_;
  double stiffness_;
  std::vector<Spring>& out_;
};

/// Blocks that hang together.
struct Group {
  std::vector<bool> member;  ///< of all blocks
  Vec2 centre = Vec2::Zero();
  double size = 0;
};

/// Rows of the springs of a group on its three rigid motions (x, y, rotation about the centre, scaled to
/// lengths).
Eigen::MatrixXd rigid_rows(const Body& body, const std::vector<Spring>& springs, const Group& group) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(springs.size()), 3);
  for (std::size_t s = 0; s < springs.size(); ++s)
    for (const auto& [block, row] : springs[s].displacement.rows) {
      // Jumps are none of the rigid motions of the whole.
      if (block.value() >= group.member.size() || !group.member[block.value()]) continue;
      const Vec2 x = body.block(block).moments.centroid - group.centre;
      const double turn = (row[2] - row[0] * x.y() + row[1] * x.x()) / group.size;
      rows.row(static_cast<Eigen::Index>(s)) += Eigen::RowVector3d(row[0], row[1], turn);
    }
  for (Eigen::Index r = 0; r < rows.rows(); ++r)  // zero for the springs of other groups
    if (const double norm = rows.row(r).norm(); norm > 0) rows.row(r) /= norm;
  return rows;
}

/// "translation in x", "translation in y", "rotation", or "rotation about (x, y)".
std::string motion_name(const Eigen::Vector3d& motion, const Vec2& centre, double size) {
  constexpr double small = 1e-6;
  if (std::abs(motion[2]) < small) {
    if (std::abs(motion[1]) < small) return "translation in x";
    if (std::abs(motion[0]) < small) return "translation in y";
    return fmt::format("translation along ({:.3g}, {:.3g})", motion[0], motion[1]);
  }
  Vec2 pole = centre + size / motion[2] * Vec2(-motion[1], motion[0]);
  for (double& x : pole)
    if (std::abs(x) < small * size) x = 0;
  return fmt::format("rotation about ({:.4g}, {:.4g})", pole.x(), pole.y());
}

std::string free_motions(const Eigen::MatrixXd& rows, const Vec2& centre, double size) {
  const Eigen::Matrix3d gram = rows.transpose() * rows;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(gram, Eigen::ComputeFullV);
  std::vector<Eigen::Vector3d> free;
  for (int i = 0; i < 3; ++i)
    if (svd.singularValues()[i] <= 1e-12 * std::max(1.0, svd.singularValues()[0]))
      free.push_back(svd.matrixV().col(i));
  if (free.size() == 3) return "translation in x, translation in y, rotation";
  std::string names;
  for (const auto& motion : free) names += (names.empty() ? "" : ", ") + motion_name(motion, centre, size);
  return names;
}

}  // namespace

std::vector<BoundaryPoint> points_held_along(const Body& body, const ModelParameters& model) {
  constexpr double along = 0.5;
  std::vector<BoundaryPoint> out;
  for (const auto& [name, support] : model.supports) {
    if (!support.boundary) continue;
    for (const BoundaryPoint& point : held_points(body, *support.boundary, support.where))
      if (std::ranges::any_of(directions(support, point.normal), [&](const auto& named) {
            return std::abs(cross(named.second, point.normal)) > along;
          }))
        out.push_back(point);
  }
  return out;
}

std::vector<Spring> make_supports(const Body& body, const ModelParameters& model, Findings& findings) {
  std::vector<Spring> out;
  SupportMaker maker(body, model.support_stiffness * body.largest_modulus() * body.thickness, out);
  for (const auto& [name, support] : model.supports) {
    try {
      maker.add(name, support);
    } catch (const InputError& error) {
      findings.add(error);
    }
  }
  return out;
}

void add_changing_springs(const std::vector<Spring>& supports, const std::string& name, std::size_t stage,
                          std::vector<ChangingSpring>& out) {
  for (std::size_t i = 0; i < supports.size(); ++i)
    if (supports[i].support == name) out.push_back({i, stage});
}

std::vector<ChangingSpring> added_springs(const std::vector<Spring>& supports, const ModelParameters& model,
                                          Findings& findings) {
  const std::vector<StageParameters> stages = model.loaded_stages();
  std::vector<std::string> names;
  for (std::size_t s = model.num_dead_stages(); s < stages.size(); ++s) names.push_back(stages[s].name);
  for (const auto& [name, support] : model.supports)
    if (!support.from.empty() && std::ranges::count(names, support.from) != 1)
      findings.add(
          support.where,
          fmt::format(
              "`from: {}` is not the name of one stage with loads that a load factor multiplies, as all have "
              "from the first with `until` on{}",
              support.from, suggest(support.from, names)));
  std::vector<ChangingSpring> out;
  for (std::size_t s = 0; s < stages.size(); ++s)
    for (const auto& [name, support] : model.supports)
      if (!support.from.empty() && support.from == stages[s].name)
        add_changing_springs(supports, name, s, out);
  return out;
}

std::vector<Spring> springs_of_planes(const Body& body) {
  std::vector<Spring> out;
  for (const Side& side : body.assembly.sides) {
    if (!side.is_mirror()) continue;
    const Vec2 edge = side.end - side.start, normal = Vec2(edge.y(), -edge.x()) / edge.norm();
    for (const Vec2& x : {side.start, side.end}) {
      Functional displacement;
      for (const auto& [node, rows] : motions_at(body, side.first, x))
        displacement.rows.emplace_back(node, rows.transpose() * normal);
      out.push_back({"", std::move(displacement), 1});
    }
  }
  return out;
}

void check_rigid_motions(const Body& body, const std::vector<Spring>& springs, const Position& where,
                         Findings& findings) {
  for (const auto& blocks : connected_groups(body.assembly)) {
    Group group{.member = std::vector<bool>(body.assembly.num_blocks(), false)};
    double area = 0;
    for (const BlockId id : blocks) {
      group.member[id.value()] = true;
      group.centre += body.block(id).moments.area * body.block(id).moments.centroid;
      area += body.block(id).moments.area;
    }
    group.centre /= area;
    group.size = std::sqrt(area);
    const std::string names = free_motions(rigid_rows(body, springs, group), group.centre, group.size);
    if (names.empty()) continue;
    const bool turns = names.find("rotation") != std::string::npos;
    findings.add(
        where,
        fmt::format(
            "no support holds the {} blocks around ({:.4g}, {:.4g}) against: {}{}", blocks.size(),
            group.centre.x(), group.centre.y(), names,
            turns ? "; a support `at` a point or `over` a patch lets it turn, one of a `boundary` holds it"
                  : ""));
  }
}

}  // namespace dda
