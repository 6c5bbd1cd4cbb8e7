#include "framework/deck/formula.hpp"
#include "meshing/geometry/triangle_rule.hpp"
#include "models/body/chosen.hpp"
#include "models/body/motion.hpp"
#include "models/load/load.hpp"
#include "models/load/quadrature.hpp"

namespace dda {
namespace {

struct BodyForceParameters {
  VectorFormula force;
  std::vector<std::string> regions, materials;
  Position where;
};

/// A force per volume, such as self-weight: f += ∫ Tᵀ b dV, ∫ Gᵀ b dV on the strain gradients of blocks of second order, and
/// ∫ Jᵀ b dV on the jumps of what lies beyond cuts. An even one acts on the centroid's translations alone of T; all else
/// is integrated to 1e-11.
class BodyForce final : public Load {
 public:
  explicit BodyForce(BodyForceParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    const Chosen chosen{p_.regions, p_.materials};
    chosen.require_known(body, p_.where);
    for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i) {
      if (!chosen.has(body, BlockId{i})) continue;
      const Block& block = body.block(BlockId{i});
      const auto rows = [&](const Vec2& x) { return displacement_rows(x - block.moments.centroid); };
      const Vec6 force = integral_of({block.outline, block.moments, body.thickness}, rows);
      Eigen::Map<Vec6>(stage.force.data() + 6 * i) += force;
      add_to_gradient(stage, body, BlockId{i});
      if (body.cracks) add_to_jumps(stage, body, BlockId{i});
      stage.resultant += force.head<2>().norm();
    }
  }

 private:
  /// f += ∫ Gᵀ b dV, u = G g.
  void add_to_gradient(StageLoads& stage, const Body& body, BlockId id) const {
    const auto node = body.gradient_of(id);
    if (!node) return;
    const auto density = [&](const Vec2& x) -> Integrals {
      return gradient_motion(body, id, x).transpose() * p_.force(x);
    };
    const Block& block = body.block(id);
    Integrals sum = Integrals::Zero();
    if (p_.force.is_constant())  // G is quadratic in the place
      for_each_quadrature_point(block.outline, block.moments.centroid,
                                [&](double weight, const Vec2& x) { sum += weight * density(x); });
    else
      sum = integral(block.outline, density);
    Eigen::Map<Vec6>(stage.force.data() + 6 * node->value()) += body.thickness * sum;
  }
  /// f += ∫ Jᵀ b dV over what a jump moves.
  void add_to_jumps(StageLoads& stage, const Body& body, BlockId id) const {
    for (const Part& part : body.cracks->parts(id)) {
      const Moments of = moments(part.outline);
      for (const JumpId jump : part.jumps)
        Eigen::Map<Vec6>(stage.force.data() + 6 * body.node_of(jump).value()) += integral_of(
            {part.outline, of, body.thickness}, [&](const Vec2& x) { return motion_of(body, jump, x).rows; });
    }
  }
  struct Volume {
    const Polygon& outline;
    const Moments& moments;
    double thickness;
  };
  /// ∫ Nᵀ b dV, N the rows of a displacement linear in the place.
  template <class Rows>
  Vec6 integral_of(const Volume& of, const Rows& rows) const {
    const Vec2& centroid = of.moments.centroid;
    if (p_.force.is_constant())
      return rows(centroid).transpose() * (of.moments.area * of.thickness * p_.force(centroid));
    const auto density = [&](const Vec2& x) -> Integrals { return rows(x).transpose() * p_.force(x); };
    return of.thickness * integral(of.outline, density);
  }
  BodyForceParameters p_;
};

Schema<BodyForceParameters> schema() {
  using P = BodyForceParameters;
  return Schema<P>("A force per volume, such as self-weight, even or a function of x and y.")
      .value("force", &P::force, vector_formula_kind(dimension::body_force),
             {.text = "Force per volume (bx, by), each a number or an expression of x and y."})
      .texts("materials", &P::materials,
             {.fallback = std::vector<std::string>{},
              .text = "Materials it acts on; with those of `regions` all that are named, all there are when "
                      "none is."})
      .texts("regions", &P::regions,
             {.fallback = std::vector<std::string>{}, .text = "Names of the regions it acts on."});
}

}  // namespace

DDA_REGISTER(loads(), "body_force", schema(), make_of<BodyForce>);

}  // namespace dda
