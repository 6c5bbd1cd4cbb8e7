#include <algorithm>

#include "framework/deck/formula.hpp"
#include "models/load/load.hpp"
#include "models/load/quadrature.hpp"

namespace dda {
namespace {

struct InitialStressParameters {
  Formula xx, yy, xy;
  std::vector<std::string> regions;
};

/// A stress σ0 present without strain (prestress, shrinkage, the stress in a rock mass): σ = C ε + σ0, f −= V Eᵀ σ0 with
/// the mean σ0 of each block.
class InitialStress final : public Load {
 public:
  explicit InitialStress(InitialStressParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    stage.initial_stress.resize(body.assembly.num_blocks(), Vec3::Zero());
    for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i) {
      const auto& region = body.assembly.regions[static_cast<std::size_t>(body.assembly.blocks[i].region)];
      if (!p_.regions.empty() && std::ranges::find(p_.regions, region.name) == p_.regions.end()) continue;
      const Vec3 stress = mean_stress(body.block(BlockId{i}));
      stage.initial_stress[i] += stress;
      Eigen::Map<Vec6>(stage.force.data() + 6 * i).tail<3>() -= body.volume(BlockId{i}) * stress;
    }
  }

 private:
  Vec3 stress_at(const Vec2& x) const { return {p_.xx(x), p_.yy(x), p_.xy(x)}; }
  Vec3 mean_stress(const Block& block) const {
    if (p_.xx.is_constant() && p_.yy.is_constant() && p_.xy.is_constant())
      return stress_at(block.moments.centroid);
    const Integrals sum = integral(block.outline, [&](const Vec2& x) {
      Integrals out = Integrals::Zero();
      out.head<3>() = stress_at(x);
      return out;
    });
    return sum.head<3>() / block.moments.area;
  }

  InitialStressParameters p_;
};

Schema<InitialStressParameters> schema() {
  using P = InitialStressParameters;
  return Schema<P>(
             "A stress that is there without strain: prestress, shrinkage; even or a function of x and y.")
      .value(
          "xx", &P::xx, formula_kind(dimension::stress),
          {.fallback = Formula(), .text = "σx, tension positive; each a number or an expression of x and y."})
      .value("yy", &P::yy, formula_kind(dimension::stress),
             {.fallback = Formula(), .text = "σy, tension positive."})
      .value("xy", &P::xy, formula_kind(dimension::stress), {.fallback = Formula(), .text = "τxy."})
      .texts(
          "regions", &P::regions,
          {.fallback = std::vector<std::string>{}, .text = "Names of the regions it is in; all when empty."});
}

}  // namespace

DDA_REGISTER(loads(), "initial_stress", schema(), make_of<InitialStress>);

}  // namespace dda
