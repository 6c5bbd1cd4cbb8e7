#include "verification/cantilever.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "models/body/motion.hpp"
#include "models/body/place.hpp"

namespace dda::verification {
namespace {

/// A rule of degree five on a triangle: seven points as (a, b, b) with their weight (Radon).
struct TrianglePoint {
  Vec3 barycentric;
  double weight;
};

std::array<TrianglePoint, 7> radon() {
  const double root = std::sqrt(15.0);
  std::array<TrianglePoint, 7> out;
  out[0] = {Vec3::Constant(1.0 / 3), 9.0 / 40};
  const double b[] = {(6 - root) / 21, (6 + root) / 21};
  const double w[] = {(155 - root) / 1200, (155 + root) / 1200};
  for (std::size_t i = 0; i < 2; ++i)
    for (Eigen::Index corner = 0; corner < 3; ++corner) {
      Vec3 at = Vec3::Constant(b[i]);
      at[corner] = 1 - 2 * b[i];
      out[1 + 3 * i + static_cast<std::size_t>(corner)] = {at, w[i]};
    }
  return out;
}

/// ∫ f dA over a convex polygon, as a fan of triangles about its centroid.
template <class Function>
double integral(const Block& block, const Function& f) {
  static const auto rule = radon();
  double sum = 0;
  const Vec2& c = block.moments.centroid;
  for (std::size_t i = 0; i < block.outline.size(); ++i) {
    const Vec2 &a = block.outline.at(i), &b = block.outline.at(i + 1);
    const double area = 0.5 * cross(a - c, b - c);
    for (const TrianglePoint& point : rule)
      sum += area * point.weight *
             f(point.barycentric[0] * c + point.barycentric[1] * a + point.barycentric[2] * b);
  }
  return sum;
}

Vec2 displacement_at(const Body& body, BlockId block, std::span<const double> d, const Vec2& x) {
  Vec2 out = Vec2::Zero();
  for (const auto& [node, rows] : motions_at(body, block, x))
    out += rows * Eigen::Map<const Vec6>(d.data() + 6 * node.value());
  return out;
}

Vec2 rigid_motion(int which, const Vec2& x) {
  return which == 0 ? Vec2(1, 0) : which == 1 ? Vec2(0, 1) : Vec2(-x.y(), x.x());
}

/// ‖u_h − u‖ / ‖u‖; of a beam that is held at two points alone but for a rigid motion.
double relative_error(const Cantilever& beam, const Body& body, const std::vector<double>& d) {
  const Assembly& assembly = body.assembly;
  Mat3 moments = Mat3::Zero();
  Vec3 rigid = Vec3::Zero();
  double wrong = 0, all = 0;
  for (std::size_t i = 0; i < assembly.num_blocks(); ++i) {
    const Block& block = assembly.blocks[i];
    const auto error = [&](const Vec2& x) {
      return Vec2(displacement_at(body, BlockId{i}, d, x) - beam.displacement(x));
    };
    wrong += integral(block, [&](const Vec2& x) { return error(x).squaredNorm(); });
    all += integral(block, [&](const Vec2& x) { return beam.displacement(x).squaredNorm(); });
    for (int a = 0; a < 3; ++a) {
      rigid[a] += integral(block, [&](const Vec2& x) { return rigid_motion(a, x).dot(error(x)); });
      for (int b = 0; b < 3; ++b)
        moments(a, b) +=
            integral(block, [&](const Vec2& x) { return rigid_motion(a, x).dot(rigid_motion(b, x)); });
    }
  }
  if (beam.is_clamped) return std::sqrt(wrong / all);
  return std::sqrt((wrong - rigid.dot(moments.ldlt().solve(rigid))) / all);
}

/// Adds the exact traction of a boundary: ∫ Tᵀ σ n dS by three Gauss points, σ and T of degree two.
void add_tractions(const Cantilever& beam, const Structure& structure, const std::string& boundary,
                   StageLoads& loads) {
  const double g = 0.5 * std::sqrt(0.6);
  const std::pair<double, double> rule[] = {{0.5 - g, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + g, 5.0 / 18}};
  for (const BoundarySide& side : structure.assembly.boundary) {
    if (!side.boundary || structure.assembly.boundaries[static_cast<std::size_t>(*side.boundary)] != boundary)
      continue;
    const Vec2 edge = side.end - side.start, normal = Vec2(edge.y(), -edge.x()) / edge.norm();
    for (const auto& [share, weight] : rule) {
      const Vec2 x = side.start + share * edge;
      const Vec3 s = beam.stress(x);
      const Vec2 traction(s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y());
      add_point_force(loads, structure.body, side.block,
                      {x, weight * edge.norm() * structure.body.thickness * traction});
    }
  }
}

/// Pulls the springs of `fix: xy` along a boundary to the exact displacement.
void add_pulled_springs(const Cantilever& beam, const Structure& structure, const std::string& boundary,
                        StageLoads& loads) {
  const double stiffness = structure.deck.support_stiffness * beam.young * beam.thickness;
  for (const BoundaryPoint& point : boundary_points(structure.body, boundary, {}))
    add_point_force(loads, structure.body, point.block, {point.x, stiffness * beam.displacement(point.x)});
}

}  // namespace

Vec2 Cantilever::displacement(const Vec2& x) const {
  const double nu = is_plane_strain ? poisson / (1 - poisson) : poisson;
  const double e = is_plane_strain ? young / (1 - poisson * poisson) : young;
  const double y = x.y(), h2 = height * height;
  const double scale = shear / (6 * e * inertia());
  return scale * Vec2(-y * ((6 * length - 3 * x.x()) * x.x() + (2 + nu) * (y * y - h2 / 4)),
                      3 * nu * y * y * (length - x.x()) + (4 + 5 * nu) * h2 * x.x() / 4 +
                          (3 * length - x.x()) * x.x() * x.x());
}

Vec3 Cantilever::stress(const Vec2& x) const {
  const double y = x.y();
  return {-shear * (length - x.x()) * y / inertia(), 0,
          shear / (2 * inertia()) * (height * height / 4 - y * y)};
}

std::string Cantilever::deck(const std::string& subdivision, const std::string& joint) const {
  return fmt::format(R"(
scene:
  regions:
    - {{name: beam, material: concrete, vertices: [[0, {0}], [{1}, {0}], [{1}, {2}], [0, {2}]]}}
  boundaries: {{clamp: [[0, {2}], [0, {0}]], tip: [[{1}, {0}], [{1}, {2}]]}}
  subdivision: {3}
thickness: {4}
plane: {8}
kinematics: {9}
materials: {{concrete: {{type: linear_elastic, young_modulus: {5}, poisson_ratio: {6}}}}}
interfaces:
  joints: {{between: [concrete, concrete], {7}}}
supports: {10}
stages: [{{loads: [{{type: edge_traction, boundary: tip, traction: [0, 1]}}]}}]
)",
                     -height / 2, length, height / 2, subdivision, thickness, young, poisson, joint,
                     is_plane_strain ? "strain" : "stress", kinematics,
                     is_clamped
                         ? "{wall: {boundary: clamp, fix: xy}}"
                         : fmt::format("{{pin: {{at: [0, {0}], fix: xy}}, roller: {{at: [0, {1}], fix: x}}}}",
                                       -height / 2, height / 2));
}

CantileverResult solve_cantilever(const Cantilever& beam, const std::string& subdivision,
                                  const std::string& joint) {
  const Structure structure(beam.deck(subdivision, joint));
  StageLoads loads;
  loads.force.assign(structure.equilibrium.num_unknowns(), 0.0);
  add_tractions(beam, structure, "clamp", loads);
  add_tractions(beam, structure, "tip", loads);
  if (beam.is_clamped) add_pulled_springs(beam, structure, "clamp", loads);
  const auto d = solve(structure.equilibrium.intact(), loads.force);
  const Functional tip = dda::displacement_at(structure.body, {Spot(beam.length, 0), {}, {}}, {0, 1}, {});
  return {structure.assembly.num_blocks(), relative_error(beam, structure.body, d), tip.value(d, 0)};
}

}  // namespace dda::verification
