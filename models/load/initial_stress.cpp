#include <algorithm>

#include "models/load/load.hpp"

namespace dda {
namespace {

struct InitialStressParameters {
  double xx = 0, yy = 0, xy = 0;
  std::vector<std::string> regions;
};

/// A stress σ0 present without strain (prestress, shrinkage): σ = C ε + σ0, f −= V Eᵀ σ0.
class InitialStress final : public Load {
 public:
  explicit InitialStress(InitialStressParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    stage.initial_stress.resize(body.assembly.num_blocks(), Vec3::Zero());
    const Vec3 stress(p_.xx, p_.yy, p_.xy);
    for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i) {
      const auto& region = body.assembly.regions[static_cast<std::size_t>(body.assembly.blocks[i].region)];
      if (!p_.regions.empty() && std::ranges::find(p_.regions, region.name) == p_.regions.end()) continue;
      stage.initial_stress[i] += stress;
      Eigen::Map<Vec6>(stage.force.data() + 6 * i).tail<3>() -= body.volume(BlockId{i}) * stress;
    }
  }

 private:
  InitialStressParameters p_;
};

Schema<InitialStressParameters> schema() {
  using P = InitialStressParameters;
  return Schema<P>("A stress that is there without strain: prestress, shrinkage.")
      .number("xx", &P::xx,
              {.fallback = 0.0, .dimension = dimension::stress, .text = "σx, tension positive."})
      .number("yy", &P::yy,
              {.fallback = 0.0, .dimension = dimension::stress, .text = "σy, tension positive."})
      .number("xy", &P::xy, {.fallback = 0.0, .dimension = dimension::stress, .text = "τxy."})
      .texts(
          "regions", &P::regions,
          {.fallback = std::vector<std::string>{}, .text = "Names of the regions it is in; all when empty."});
}

}  // namespace

DDA_REGISTER(loads(), "initial_stress", schema(), make_of<InitialStress>);

}  // namespace dda
