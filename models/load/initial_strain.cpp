#include "models/load/eigenstress.hpp"

namespace dda {
namespace {

struct InitialStrainParameters {
  Formula xx, yy, zz, xy;
  double expansion = 0;
  Formula temperature;
  std::vector<std::string> regions, materials;
  Position where;
};

/// A strain that is there without stress (warming, cooling, shrinkage, swelling),
///
///     ε0 = (xx, yy, xy) + αT (1, 1, 0),   ε0z = zz + αT,   σ = C (ε − ε0 − ν ε0z (1, 1, 0)*)
///
/// * in plane strain alone, where the strain out of the plane is held. What is free to move moves by it without stress;
/// what is held is stressed by σ0 = −C ε0, f += V Eᵀ C ε0 with the means of each block, and the linear part of ε0 in blocks
/// of second order (eigenstress.hpp). Out of the plane comes what a
/// strain of −ε0 makes, and ε0z (Material::out_of_plane).
class InitialStrain final : public Load {
 public:
  explicit InitialStrain(InitialStrainParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    const Chosen chosen{p_.regions, p_.materials};
    chosen.require_known(body, p_.where);
    for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i)
      if (const BlockId id{i}; chosen.has(body, id)) add_eigenstress(stage, body, id, eigenstress(body, id));
  }

 private:
  LinearField<Eigenstress> eigenstress(const Body& body, BlockId id) const {
    const Material& material = body.material(id);
    const LinearField<Vec3> beside = linear_over(body, id, {p_.temperature, p_.zz, Formula()}),
                            strain = linear_over(body, id, {p_.xx, p_.yy, p_.xy});
    return {eigenstress(material, beside.mean, strain.mean),
            {eigenstress(material, beside.slopes[0], strain.slopes[0]),
             eigenstress(material, beside.slopes[1], strain.slopes[1])}};
  }

  /// Of T and ε0z and of the strain in the plane.
  Eigenstress eigenstress(const Material& material, const Vec3& beside, const Vec3& in_plane) const {
    const double warming = p_.expansion * beside[0], out_of_plane = beside[1] + warming;
    const double held = material.held_contraction() * out_of_plane;
    const Vec3 strain = in_plane + (warming + held) * Vec3(1, 1, 0);
    return {-material.stiffness() * strain,
            material.out_of_plane_by_free_strain() * out_of_plane - material.out_of_plane().dot(strain)};
  }

  InitialStrainParameters p_;
};

Schema<InitialStrainParameters> schema() {
  using P = InitialStrainParameters;
  const auto strain = formula_kind(dimension::none);
  return Schema<P>(
             "A strain that is there without stress: warming or cooling (`expansion`, `temperature`), "
             "shrinkage, "
             "swelling; even or functions of x and y. What is free moves by it, what is held is stressed.")
      .value("xx", &P::xx, strain,
             {.fallback = Formula(),
              .text = "εx, lengthening positive; each a number or an expression of x and y."})
      .value("yy", &P::yy, strain, {.fallback = Formula(), .text = "εy, lengthening positive."})
      .value("xy", &P::xy, strain, {.fallback = Formula(), .text = "γxy, twice the tensor's component."})
      .value("zz", &P::zz, strain,
             {.fallback = Formula(),
              .text = "εz out of the plane; in plane strain, which holds it, it is stressed."})
      .number("expansion", &P::expansion,
              {.fallback = 0, .text = "Thermal expansion α, strain by degree; 1e-5 for concrete."})
      .value("temperature", &P::temperature, formula_kind(dimension::none),
             {.fallback = Formula(),
              .text = "Change of temperature T in degrees, warming positive: strains αT in all directions."})
      .texts(
          "regions", &P::regions,
          {.fallback = std::vector<std::string>{},
           .text =
               "Names of the regions it is in; with those of `materials` all that are named, all there are "
               "when none is."})
      .texts("materials", &P::materials,
             {.fallback = std::vector<std::string>{}, .text = "Materials it is in."})
      .check([](const P& p, const Position& where, Findings& findings) {
        const bool is_warm = !p.temperature.is_constant() || p.temperature(Vec2::Zero()) != 0;
        if (is_warm != (p.expansion != 0))
          findings.add(where, "`expansion` and `temperature` go together: their product is the strain");
      });
}

}  // namespace

DDA_REGISTER(loads(), "initial_strain", schema(), make_of<InitialStrain>);

}  // namespace dda
