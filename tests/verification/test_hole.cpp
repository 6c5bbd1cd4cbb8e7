// A quarter of a plate with a hole under tension, blocks of both orders against Kirsch's displacements. The hole is of
// straight chords; each side of the boundary, the chords among them, has the exact traction there, so that what is
// computed is the exact field on the polygon.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "meshing/geometry/triangle_rule.hpp"
#include "models/body/motion.hpp"
#include "verification/assemblies.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

constexpr double young = 1, poisson = 0.3, outer_radius = 4;

/// Of a hole of radius 1 in plane stress, σx = 1 far away.
Vec2 kirsch_displacement(const Vec2& x) {
  const double r = x.norm(), angle = std::atan2(x.y(), x.x());
  const double shear = young / (2 * (1 + poisson)), kappa = (3 - poisson) / (1 + poisson);
  const double c = std::cos(angle), s = std::sin(angle), c3 = std::cos(3 * angle), s3 = std::sin(3 * angle);
  return Vec2(r * (kappa + 1) * c + 2 / r * ((1 + kappa) * c + c3) - 2 / (r * r * r) * c3,
              r * (kappa - 3) * s + 2 / r * ((1 - kappa) * s + s3) - 2 / (r * r * r) * s3) /
         (8 * shear);
}

/// The traction of Kirsch's stress on a side with outer normal n, as formulas of x and y.
std::string kirsch_traction(const Vec2& n) {
  const std::string a2 = "(1/(x*x + y*y))", c2 = "((x*x - y*y)/(x*x + y*y))", s2 = "(2*x*y/(x*x + y*y))";
  const std::string c4 = fmt::format("(2*{0}*{0} - 1)", c2), s4 = fmt::format("(2*{}*{})", s2, c2);
  const std::string a4 = fmt::format("(1.5*{0}*{0})", a2);
  const std::string sx = fmt::format("(1 - {0}*(1.5*{1} + {2}) + {3}*{2})", a2, c2, c4, a4);
  const std::string sy = fmt::format("(-{0}*(0.5*{1} - {2}) - {3}*{2})", a2, c2, c4, a4);
  const std::string t = fmt::format("(-{0}*(0.5*{1} + {2}) + {3}*{2})", a2, s2, s4, a4);
  return fmt::format("[\"{0}*({2:.17g}) + {1}*({3:.17g})\", \"{1}*({2:.17g}) + {4}*({3:.17g})\"]", sx, t,
                     n.x(), n.y(), sy);
}

/// Quads between `rings` + 1 circles, whose radii grow by a constant factor, and 2 `rings` + 1 rays.
struct Quarter {
  int rings;

  Vec2 at(int ring, int ray) const {
    const double r = std::pow(outer_radius, static_cast<double>(ring) / rings);
    const double angle = std::numbers::pi / 2 * ray / (2 * rings);
    return r * Vec2(std::cos(angle), std::sin(angle));
  }
  Drawing drawing() const {
    Drawing out{fmt::format("{} quads", 2 * rings * rings), {}, {}};
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < 2 * rings; ++j)
        out.regions.emplace_back("m", Polygon{{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
    auto& outline = out.outline.vertices;
    for (int i = 0; i < rings; ++i) outline.push_back(at(i, 0));
    for (int j = 0; j < 2 * rings; ++j) outline.push_back(at(rings, j));
    for (int i = rings; i > 0; --i) outline.push_back(at(i, 2 * rings));
    for (int j = 2 * rings; j > 0; --j) outline.push_back(at(0, j));
    return out;
  }
};

std::string deck_of(const Drawing& drawing, const std::string& kinematics) {
  std::string tractions;
  for (std::size_t i = 0; i < drawing.outline.size(); ++i) {
    const Vec2 edge = (drawing.outline.at(i + 1) - drawing.outline.at(i)).normalized();
    tractions += fmt::format("      - {{type: edge_traction, boundary: side{}, traction: {}}}\n", i,
                             kirsch_traction({edge.y(), -edge.x()}));
  }
  return scene_text(drawing) + fmt::format(R"(
thickness: 1
weak_springs: 0
kinematics: {}
materials: {{m: {{type: linear_elastic, young_modulus: {}, poisson_ratio: {}}}}}
supports: {{pin: {{at: [{}, 0], fix: xy}}, roller: {{at: [0, {}], fix: x}}}}
stages:
  - loads:
{})",
                                           kinematics, young, poisson, outer_radius, outer_radius, tractions);
}

/// ‖u_h − u‖ / ‖u‖ over the area, but for a rigid motion.
double error_of(int rings, const std::string& kinematics) {
  const Structure s(deck_of(Quarter{rings}.drawing(), kinematics));
  const auto d = intact_response(s.equilibrium);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rigid = Eigen::Vector3d::Zero();
  double square_of_error = 0, square = 0;
  for (std::size_t b = 0; b < s.assembly.num_blocks(); ++b) {
    const Block& block = s.assembly.blocks[b];
    for_each_quadrature_point(block.outline, block.moments.centroid, [&](double weight, const Vec2& x) {
      Vec2 error = -kirsch_displacement(x);
      square += weight * error.squaredNorm();
      for (const auto& [node, rows] : motions_at(s.body, BlockId{b}, x))
        error += rows * Eigen::Map<const Vec6>(d.data() + 6 * node.value());
      Eigen::Matrix<double, 2, 3> motion;
      motion << 1, 0, -x.y(), 0, 1, x.x();
      moments += weight * motion.transpose() * motion;
      rigid += weight * motion.transpose() * error;
      square_of_error += weight * error.squaredNorm();
    });
  }
  return std::sqrt((square_of_error - rigid.dot(moments.ldlt().solve(rigid))) / square);
}

TEST(Hole, SecondOrderFollowsKirschWithThirdOrder) {
  const double coarse = error_of(8, "second_order"), fine = error_of(16, "second_order");
  EXPECT_LE(coarse, 1.6e-4);
  EXPECT_LE(fine, 1.7e-5);
  EXPECT_GE(std::log2(coarse / fine), 2.8);
}

TEST(Hole, FirstOrderFollowsKirschWithSecondOrder) {
  const double coarse = error_of(8, "first_order"), fine = error_of(16, "first_order");
  EXPECT_LE(fine, 0.01);
  EXPECT_GE(std::log2(coarse / fine), 1.7);
}

}  // namespace
}  // namespace dda::verification
