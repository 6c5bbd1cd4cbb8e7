// Strains that are there without a load, platens: closed forms of the intact structure.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Cholesky>

#include "support/dense.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

using testing::HasSubstr;

/// Two columns 1 × 2 side by side, of E = 2 and E = 6, that nothing joins, on a common foot; ν = 0 unless said.
std::string columns(const std::string& stages, const std::string& more = "", double nu = 0) {
  return fmt::format(R"(
scene:
  regions:
    - {{name: soft, material: soft, vertices: [[0, 0], [1, 0], [1, 2], [0, 2]]}}
    - {{name: hard, material: hard, vertices: [[1, 0], [2, 0], [2, 2], [1, 2]]}}
  boundaries: {{foot: [[0, 0], [2, 0]], head: [[0, 2], [2, 2]]}}
  curves: {{gap: [[1, 0], [1, 2]]}}
thickness: 0.5
materials:
  soft: {{type: linear_elastic, young_modulus: 2, poisson_ratio: {0}}}
  hard: {{type: linear_elastic, young_modulus: 6, poisson_ratio: {0}}}
interfaces: {{gap: {{law: {{type: elastic, normal_stiffness: 1e-9, shear_stiffness: 1e-9}}, treatment: penalty}}}}
supports: {{foot: {{boundary: foot, fix: xy}}}}
stages:
{1}{2})",
                     nu, stages, more);
}

/// K0⁻¹ (dead + λ reference) by a dense factorisation.
std::vector<double> solved(const Equilibrium& equilibrium, const Loading& loading, double load_factor) {
  const auto n = static_cast<Eigen::Index>(equilibrium.num_unknowns());
  const Eigen::VectorXd force = Eigen::Map<const Eigen::VectorXd>(loading.dead.data(), n) +
                                load_factor * Eigen::Map<const Eigen::VectorXd>(loading.reference.data(), n);
  const Eigen::VectorXd d = dense(equilibrium.intact()).ldlt().solve(force);
  return {d.begin(), d.end()};
}

double gauge(const Loading& loading, const std::string& name, const std::vector<double>& d,
             double load_factor) {
  for (const NamedGauge& named : loading.gauges)
    if (named.name == name) return named.functional.value(d, load_factor);
  throw std::logic_error("no gauge " + name);
}

constexpr auto stress_gauges = R"(
gauges:
  soft: {type: stress, at: [0.5, 1], component: yy}
  hard: {type: stress, regions: [hard], component: yy}
  both: {type: stress, regions: [soft, hard], component: yy}
  longer: {type: strain, at: [0.5, 1], component: yy}
)";

TEST(InitialStrain, OfAFreeColumnIsItsStrainWithoutStress) {
  for (const char* plane : {"stress", "strain"}) {
    const Structure made(columns(
        "  - {loads: [{type: initial_strain, expansion: 1e-3, temperature: 30, materials: [soft]}]}\n",
        std::string(stress_gauges) + "plane: " + plane + "\n"));
    const Equilibrium equilibrium = made.equilibrium();
    const Loading& loading = equilibrium.stages().back();
    const std::vector<double> d = solved(equilibrium, loading, 0.5);
    EXPECT_NEAR(gauge(loading, "longer", d, 0.5), 0.015, 1e-9 * 0.015)
        << "the foot alone hinders it sideways";
    EXPECT_NEAR(gauge(loading, "soft", d, 0.5), 0, 1e-10);
    EXPECT_NEAR(gauge(loading, "hard", d, 0.5), 0, 1e-10);
  }
}

/// −C ε0 in every block that is held everywhere: −E αT/(1 − ν) in plane stress, −E αT/(1 − 2ν) in plane strain, in all
/// three directions; out of the plane of a plate it swells by αT (1 + ν)/(1 − ν).
TEST(InitialStrain, OfWhatIsHeldIsAllStress) {
  constexpr double nu = 0.25, warming = 1e-3 * 30;
  for (const bool is_strain : {false, true}) {
    const Structure made(
        columns("  - {loads: [{type: initial_strain, expansion: 1e-3, temperature: 30}]}\n",
                std::string(stress_gauges) + "plane: " + (is_strain ? "strain\n" : "stress\n"), nu));
    const Loading loading = made.equilibrium().stages().back();
    const std::vector<double> nothing(12, 0.0);
    const double by_modulus = -warming / (is_strain ? 1 - 2 * nu : 1 - nu);
    EXPECT_NEAR(gauge(loading, "soft", nothing, 1), 2 * by_modulus, 1e-15);
    EXPECT_NEAR(gauge(loading, "hard", nothing, 0.5), 6 * by_modulus / 2, 1e-15);
    EXPECT_NEAR(gauge(loading, "both", nothing, 1), 4 * by_modulus, 1e-15);
    EXPECT_NEAR(loading.out_of_plane(0, 1), is_strain ? 2 * by_modulus : warming * (1 + nu) / (1 - nu),
                1e-15);
  }
}

/// The same strain by its components, and by an expression of the place whose mean over a block is that of its middle.
TEST(InitialStrain, IsTheSameHoweverItIsGiven) {
  const auto loads_of = [](const std::string& load) {
    const Structure made(columns("  - {loads: [" + load + "]}\n"));
    return made.equilibrium().stages().back().reference;
  };
  const std::vector<double> warm = loads_of("{type: initial_strain, expansion: 1e-3, temperature: 30}");
  const std::vector<double> strained = loads_of("{type: initial_strain, xx: 0.03, yy: 0.03}");
  const std::vector<double> varying = loads_of("{type: initial_strain, xx: '0.03*y', yy: '0.03*y'}");
  const std::vector<double> stressed =
      loads_of("{type: initial_stress, xx: -0.06, yy: -0.06, regions: [soft]}");
  for (std::size_t i = 0; i < warm.size(); ++i) {
    EXPECT_NEAR(strained[i], warm[i], 1e-15);
    EXPECT_NEAR(varying[i], warm[i], 1e-11);
    if (i < 6) {
      EXPECT_NEAR(stressed[i], warm[i], 1e-15) << "ν = 0: −E ε0";
    }
  }
}

TEST(InitialStrain, RefusesWhatMeansNothing) {
  const auto refusal = [](const std::string& load) -> std::string {
    try {
      Structure(columns("  - {loads: [" + load + "]}\n")).equilibrium();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("{type: initial_strain, expansion: 1e-5}"), HasSubstr("go together"));
  EXPECT_THAT(refusal("{type: initial_strain, temperature: 20}"), HasSubstr("go together"));
  EXPECT_THAT(refusal("{type: initial_strain, xx: 1e-3, regions: [sft]}"), HasSubstr("unknown region 'sft'"));
  EXPECT_THAT(refusal("{type: initial_strain, xx: 1e-3, materials: [sft]}"),
              HasSubstr("unknown material 'sft'"));
  EXPECT_THAT(refusal("{type: initial_stress, xx: 1, regions: [sft]}"), HasSubstr("unknown region 'sft'"));
  EXPECT_THAT(refusal("{type: initial_stress, xx: 1, zz: 1}"), HasSubstr("`plane: strain`"));
}

/// A rigid platen shortens both columns alike: F = δ (E₁ + E₂) A/h, with the springs of foot and platen in series.
TEST(Platen, ShortensColumnsAlike) {
  const Structure made(
      columns("  - {loads: [{type: prescribed_displacement, name: press, boundary: head, direction: [0, -1], "
              "displacement: 0.1}]}\n",
              stress_gauges));
  const Equilibrium equilibrium = made.equilibrium();
  const Loading& loading = equilibrium.stages().back();
  const std::vector<double> d = solved(equilibrium, loading, 1);
  const double spring = 2 * 1e5 * 6 * 0.5;  // two springs of p̄ at each end of each column
  double force = 0;
  for (const double young : {2.0, 6.0}) {
    const double of_column = 0.1 / (2 / (young * 0.5) + 2 / spring);
    EXPECT_NEAR(gauge(loading, young == 2 ? "soft" : "hard", d, 1), -of_column / 0.5, 1e-8 * of_column);
    force += of_column;
  }
  EXPECT_NEAR(loading.reactions.at("press").value(d, 1), force, 1e-8 * force);
  EXPECT_NEAR(loading.load.value(d, 1), force, 1e-8 * force);
}

TEST(Platen, HasOnePlace) {
  try {
    Structure(columns(
        "  - {loads: [{type: prescribed_displacement, boundary: head, at: [1, 2], direction: [0, -1]}]}\n"));
    FAIL() << "a platen at a point is none";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("leave out `at`"));
  }
}

}  // namespace
}  // namespace dda
