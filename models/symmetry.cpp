#include "models/symmetry.hpp"

#include "models/body/motion.hpp"

namespace dda {

MotionRows mirrored(const MotionRows& rows, const Vec2& normal) {
  const Mat2 m = Mat2::Identity() - 2 * normal * normal.transpose();
  const double a = m(0, 0), b = m(0, 1), c = m(1, 1);
  Mat3 strain;                    // of (εx, εy, γxy)
  strain << a * a, b * b, a * b,  //
      b * b, c * c, b * c,        //
      2 * a * b, 2 * b * c, a * c + b * b;
  return {m * rows.displacement, strain * rows.strain};
}

std::vector<Spring> springs_of_mirrors(const Body& body) {
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

void check_mirrors(const ModelParameters& model, Findings& findings) {
  for (const auto& [name, interface] : model.interfaces) {
    if (interface.boundary.empty()) continue;
    if (!model.cracks.empty())
      findings.add(interface.where, "interface '" + name +
                                        "': cracks through blocks do not know planes of symmetry; describe "
                                        "the whole structure");
    if (interface.treatment.make()->multiplier() == Multiplier::unknown)
      findings.add(interface.where, "interface '" + name +
                                        "': on a plane of symmetry nothing slides that the multipliers of "
                                        "'lagrange' could tie; take another treatment");
  }
}

}  // namespace dda
