#include "models/load/eigenstress.hpp"

namespace dda {
namespace {

struct InitialStressParameters {
  Formula xx, yy, zz, xy;
  std::vector<std::string> regions, materials;
  Position where;
};

/// A stress σ0 present without strain (prestress, the stress in a rock mass): σ = C ε + σ0, f −= V Eᵀ σ0 with
/// the mean σ0 of each block, in blocks of second order with its linear part too (eigenstress.hpp). σz does no work: it is part of what is told of the stress in plane strain.
class InitialStress final : public Load {
 public:
  explicit InitialStress(InitialStressParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    const Chosen chosen{p_.regions, p_.materials};
    chosen.require_known(body, p_.where);
    for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i)
      if (const BlockId id{i}; chosen.has(body, id)) {
        require_held(body.material(id));
        const LinearField<Vec3> stress = linear_over(body, id, {p_.xx, p_.yy, p_.xy}),
                                zz = linear_over(body, id, {p_.zz, Formula(), Formula()});
        add_eigenstress(stage, body, id,
                        {{stress.mean, zz.mean[0]},
                         {{{stress.slopes[0], zz.slopes[0][0]}, {stress.slopes[1], zz.slopes[1][0]}}}});
      }
  }

 private:
  void require_held(const Material& material) const {
    const bool has_none = p_.zz.is_constant() && p_.zz(Vec2::Zero()) == 0;
    if (material.plane() == Plane::stress && !has_none)
      throw InputError(p_.where,
                       "`zz` is a stress out of the plane, which plane stress has none of: `plane: strain`");
  }

  InitialStressParameters p_;
};

Schema<InitialStressParameters> schema() {
  using P = InitialStressParameters;
  return Schema<P>(
             "A stress that is there without strain: prestress, the stress in a rock mass; even or a "
             "function of "
             "x and y.")
      .value(
          "xx", &P::xx, formula_kind(dimension::stress),
          {.fallback = Formula(), .text = "σx, tension positive; each a number or an expression of x and y."})
      .value("yy", &P::yy, formula_kind(dimension::stress),
             {.fallback = Formula(), .text = "σy, tension positive."})
      .value("xy", &P::xy, formula_kind(dimension::stress), {.fallback = Formula(), .text = "τxy."})
      .value("zz", &P::zz, formula_kind(dimension::stress),
             {.fallback = Formula(), .text = "σz out of the plane, in plane strain."})
      .texts("regions", &P::regions,
             {.fallback = std::vector<std::string>{},
              .text = "Names of the regions it is in; with those of `materials` all that are named, all "
                      "there are when "
                      "none is."})
      .texts("materials", &P::materials,
             {.fallback = std::vector<std::string>{}, .text = "Materials it is in."});
}

}  // namespace

DDA_REGISTER(loads(), "initial_stress", schema(), make_of<InitialStress>);

}  // namespace dda
