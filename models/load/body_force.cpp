#include <algorithm>

#include "framework/base/suggestion.hpp"
#include "models/body/motion.hpp"
#include "models/load/load.hpp"

namespace dda {
namespace {

struct BodyForceParameters {
  Vec2 force = Vec2::Zero();
  std::vector<std::string> materials;
  Position where;
};

/// A force per volume, such as self-weight: f += ∫ Tᵀ b dV, which acts on the centroid's translations alone, and
/// on the jumps of what lies beyond cuts.
class BodyForce final : public Load {
 public:
  explicit BodyForce(BodyForceParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    check_materials(body);
    for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i) {
      if (!acts_on(body.assembly.regions[static_cast<std::size_t>(body.assembly.blocks[i].region)].material))
        continue;
      const Vec2 force = body.volume(BlockId{i}) * p_.force;
      Eigen::Map<Vec6>(stage.force.data() + 6 * i) += displacement_rows(Vec2::Zero()).transpose() * force;
      if (body.cracks) add_to_jumps(stage, body, BlockId{i});
      stage.resultant += force.norm();
    }
  }

 private:
  /// f += ∫ Jᵀ b dV over what a jump moves.
  void add_to_jumps(StageLoads& stage, const Body& body, BlockId id) const {
    for (const Part& part : body.cracks->parts(id)) {
      const Moments of = moments(part.outline);
      const Vec2 force = of.area * body.thickness * p_.force;
      for (const JumpId jump : part.jumps) {
        const NodeMotion motion = motion_of(body, jump, of.centroid);
        Eigen::Map<Vec6>(stage.force.data() + 6 * motion.node.value()) += motion.rows.transpose() * force;
      }
    }
  }
  bool acts_on(const std::string& material) const {
    return p_.materials.empty() || std::ranges::find(p_.materials, material) != p_.materials.end();
  }
  void check_materials(const Body& body) const {
    std::vector<std::string> known;
    for (const Region& region : body.assembly.regions) known.push_back(region.material);
    for (const std::string& name : p_.materials)
      if (std::ranges::find(known, name) == known.end())
        throw InputError(p_.where, "unknown material '" + name + "'" + suggest(name, known));
  }
  BodyForceParameters p_;
};

Schema<BodyForceParameters> schema() {
  using P = BodyForceParameters;
  return Schema<P>("A force per volume, such as self-weight.")
      .point("force", &P::force, {.dimension = dimension::body_force, .text = "Force per volume (bx, by)."})
      .texts("materials", &P::materials,
             {.fallback = std::vector<std::string>{}, .text = "Materials it acts on; all when empty."});
}

}  // namespace

DDA_REGISTER(loads(), "body_force", schema(), make_of<BodyForce>);

}  // namespace dda
