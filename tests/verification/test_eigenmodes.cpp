// Eigenvalues of the stiffness: closed forms of chains of blocks, and Anasazi against a dense solver.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>

#include "continuation/linear/linear_system.hpp"
#include "continuation/stability/eigenmodes.hpp"
#include "continuation/stability/krylov_schur.hpp"
#include "continuation/stability/stiffness_modes.hpp"
#include "models/body/mass.hpp"
#include "models/equilibrium/stiffness_parts.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

constexpr double stiff = 1e5;  // ties in units of E t
constexpr double young = 27500, poisson = 0.2, height = 100, thickness = 100;

/// Blocks of the same length in a row, clamped on the left; all vertices tied by springs of 10⁵ E t, those on
/// the line `cut` such that they can crack.
std::string row_of_blocks(int blocks, double length, double cut = -1, double unit = 1,
                          const std::string& treatment = "") {
  std::string regions;
  for (int i = 0; i < blocks; ++i)
    regions += fmt::format(
        "    - {{material: concrete, vertices: [[{0:.17g}, 0], [{1:.17g}, 0], [{1:.17g}, {2:.17g}], "
        "[{0:.17g}, "
        "{2:.17g}]]}}\n",
        unit * i * length / blocks, unit * (i + 1) * length / blocks, unit * height);
  const double tie = stiff * young * thickness / unit;
  const std::string joint =
      treatment.empty() ? fmt::format("points: vertices, treatment: {{type: penalty, stiffness: {:.17g}}}",
                                      2 * tie / (unit * unit * height * thickness))
                        : "points: vertices, treatment: " + treatment;
  const std::string curve = cut < 0
                                ? ""
                                : fmt::format("  curves: {{cut: [[{0:.17g}, 0], [{0:.17g}, {1:.17g}]]}}\n",
                                              unit * cut, unit * height);
  const std::string law =
      cut < 0
          ? ""
          : fmt::format(
                "  cut: {{{}, law: {{type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}}}}\n",
                joint);
  return fmt::format(R"(
scene:
{0}  regions:
{2}
thickness: {3:.17g}
plane: stress
support_stiffness: {4}
materials:
  concrete: {{type: linear_elastic, young_modulus: {5:.17g}, poisson_ratio: {6}}}
interfaces:
  joint: {{between: [concrete, concrete], {7}}}
{8}supports:
  low: {{at: [0, 0], fix: xy}}
  high: {{at: [0, {1:.17g}], fix: xy}}
stages: [{{loads: [{{type: point_load, at: [{9:.17g}, 0], force: [0, -1]}}]}}]
)",
                     curve, unit * height, regions, unit * thickness, stiff, young / (unit * unit), poisson,
                     joint, law, unit * length);
}

/// Of the structure as it is, or with nothing left of the joints that can crack.
Eigenmodes modes_of(const Structure& structure, int count, bool with_mass, bool released = false) {
  LinearSystem linear(structure.equilibrium, direct_solvers().choose("cholmod"),
                      LinearSystem::Update::low_rank);
  if (released) {
    EXPECT_TRUE(linear.set_tangent(std::vector<Mat2>(structure.equilibrium.num_active(), Mat2::Zero())));
  }
  EigenProblem problem{.solve = [&](auto b, auto x) { linear.solve(b, x); },
                       .shifted = {},
                       .mass = unit_mass(structure.body),
                       .count = count,
                       .num_negative = linear.negative_eigenvalues().of_stiffness};
  if (!with_mass) problem.mass = Mass::identity(structure.equilibrium.num_nodes());
  return lowest_eigenmodes(problem);
}

/// λ_k = c² (6 n²/L²) (1 − cos θ)/(2 + cos θ), θ = (2k − 1) π/2n, c² = G or E/(1 − ν²); reference S2.
std::vector<double> chain(int n, double length, int count) {
  std::vector<double> out;
  for (const double c2 : {young / (2 * (1 + poisson)), young / (1 - poisson * poisson)})
    for (int k = 1; k <= n; ++k) {
      const double cosine = std::cos((2 * k - 1) * M_PI / (2 * n));
      out.push_back(c2 * 6 * n * n / (length * length) * (1 - cosine) / (2 + cosine));
    }
  std::ranges::sort(out);
  out.resize(static_cast<std::size_t>(count));
  return out;
}

TEST(Eigenmodes, ClampedBlock) {
  const double l = 400, volume = l * height * thickness;
  const Eigenmodes found = modes_of(Structure(row_of_blocks(1, l)), 2, false);
  const double shear = young / (2 * (1 + poisson)) * volume / (1.25 + l * l / 4);
  const double axial = young / (1 - poisson * poisson) * volume / (1 + l * l / 4);
  EXPECT_NEAR(found.values[0], shear, 1e-4 * shear);
  EXPECT_NEAR(found.values[1], axial, 1e-4 * axial);
  EXPECT_NEAR(shear, 1145797.5, 0.1);
  EXPECT_NEAR(axial, 2864511.7, 0.1);
}

TEST(Eigenmodes, ChainOfBlocks) {
  const std::vector<double> expected = chain(4, 400, 4);
  const Eigenmodes found = modes_of(Structure(row_of_blocks(4, 400)), 4, true);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found.values[i], expected[i], 1e-3 * expected[i]);
}

/// With densities μ is ω²: those of blocks without mass, divided by ρ.
TEST(Eigenmodes, DensitiesMakeThemFrequencies) {
  constexpr double density = 2.4e-9;
  std::string deck = row_of_blocks(4, 400);
  const std::string key = "young_modulus:";
  deck.insert(deck.find(key), fmt::format("density: {}, ", density));
  const Structure structure(deck);
  LinearSystem linear(structure.equilibrium, direct_solvers().choose("cholmod"),
                      LinearSystem::Update::low_rank);
  const Eigenmodes found = lowest_eigenmodes({.solve = [&](auto b, auto x) { linear.solve(b, x); },
                                              .shifted = {},
                                              .mass = mass_of(structure.body),
                                              .count = 4});
  const std::vector<double> expected = chain(4, 400, 4);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found.values[i], expected[i] / density, 1e-3 * expected[i] / density);
}

/// Ties by multipliers: the physical stiffness has none of them.
TEST(Eigenmodes, ChainTiedByMultipliers) {
  for (const std::string treatment : {"lagrange", "augmented_lagrangian"}) {
    const Structure structure(row_of_blocks(4, 400, -1, 1, treatment));
    System system(structure.equilibrium, direct_solvers().choose("cholmod"), LinearSystem::Update::low_rank);
    const State start{.d = std::vector<double>(structure.equilibrium.num_unknowns(), 0.0)};
    const auto found = stiffness_modes(system, start, direct_solvers().choose("cholmod"),
                                       {.count = 4, .mass = unit_mass(structure.body)});
    ASSERT_TRUE(found) << treatment;
    EXPECT_EQ(found->num_negative, 0) << treatment;
    const std::vector<double> expected = chain(4, 400, 4);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found->modes.values[i], expected[i], 1e-3 * expected[i]) << treatment;
  }
}

/// What hangs on weak springs alone has three eigenvalues near zero, the rest is the chain of half the
/// length.
TEST(Eigenmodes, ChainAfterRelease) {
  const Eigenmodes found = modes_of(Structure(row_of_blocks(4, 400, 200)), 5, true, true);
  const std::vector<double> expected = chain(2, 200, 2);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(std::abs(found.values[static_cast<std::size_t>(i)]), 1e-5 * expected[0]);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(found.values[i + 3], expected[i], 1e-3 * expected[i]);
}

/// With the mass the unit of length does not matter: μ has the unit F/L⁴.
TEST(Eigenmodes, MassMakesThemIndependentOfTheUnit) {
  const Eigenmodes mm = modes_of(Structure(row_of_blocks(4, 400)), 4, true);
  const Eigenmodes m = modes_of(Structure(row_of_blocks(4, 400, -1, 1e-3)), 4, true);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(m.values[i] * 1e-12, mm.values[i], 1e-8 * mm.values[i]);
}

/// A slender cantilever, H/L = 1/40, cut at midspan: the middle of the section is a hinge, the rest an
/// elastic layer of stiffness k_n, together a rotational spring k_θ = k_n t (H³ − h³)/12 with h = H/5 the
/// part of the hinge. Whole for k_n = 0.
Eigenmodes cracked_cantilever(double length, double stiffness) {
  const std::string rest =
      stiffness == 0
          ? "bonded"
          : fmt::format("{{type: elastic, normal_stiffness: {:.17g}, shear_stiffness: 1e-9}}", stiffness);
  const std::string hinge = stiffness == 0 ? "law: bonded"
                                           : "points: midpoint, law: {type: elastic, normal_stiffness: 1e7, "
                                             "shear_stiffness: 1e7}";
  return modes_of(Structure(fmt::format(R"(
scene:
  regions:
    - {{material: concrete, vertices: [[0, 0], [{0}, 0], [{0}, {2}], [0, {2}]]}}
    - {{material: concrete, vertices: [[{0}, 0], [{1}, 0], [{1}, {2}], [{0}, {2}]]}}
  curves: {{low: [[{0}, 0], [{0}, 40]], hinge: [[{0}, 40], [{0}, 60]], high: [[{0}, 60], [{0}, {2}]]}}
  boundaries: {{wall: [[0, 0], [0, {2}]]}}
  subdivision: {{type: grid, columns: 240, rows: 5}}
thickness: {3}
materials: {{concrete: {{type: linear_elastic, young_modulus: {4}, poisson_ratio: {5}}}}}
interfaces: {{low: {{law: {6}}}, high: {{law: {6}}}, hinge: {{{7}}}}}
supports: {{clamp: {{boundary: wall, fix: xy}}}}
stages: [{{loads: [{{type: point_load, at: [{1}, 0], force: [0, -1]}}]}}]
)",
                                        length / 2, length, height, thickness, young, poisson, rest, hinge)),
                  4, true);
}

/// Consistent joints make another, softer chain of few blocks than vertex ties do; refined, they tend to the
/// same beam: the first eigenvalue to that of Euler and Bernoulli (shear and rotary inertia take 4 · 10⁻⁴ off
/// it), with second order.
TEST(Eigenmodes, ConsistentCantileverConverges) {
  constexpr double length = 40 * height;
  const auto error = [&](int refinement) {
    const Structure structure(fmt::format(R"(
scene:
  regions: [{{material: concrete, vertices: [[0, 0], [{0}, 0], [{0}, {1}], [0, {1}]]}}]
  boundaries: {{wall: [[0, 0], [0, {1}]]}}
  subdivision: {{type: grid, columns: {2}, rows: {3}}}
thickness: {4}
materials: {{concrete: {{type: linear_elastic, young_modulus: {5}, poisson_ratio: 0}}}}
supports: {{clamp: {{boundary: wall, fix: xy}}}}
stages: [{{loads: [{{type: point_load, at: [{0}, 0], force: [0, -1]}}]}}]
)",
                                          length, height, 80 * refinement, 2 * refinement, thickness, young));
    const double euler = std::pow(1.87510407, 4) * young * height * height / 12 / std::pow(length, 4);
    return std::abs(modes_of(structure, 1, true).values[0] / euler - 1);
  };
  const double coarse = error(1), fine = error(2), finest = error(4);
  EXPECT_GT(std::log2(coarse / fine), 1.2);
  EXPECT_GT(std::log2(fine / finest), 1.7);
  EXPECT_LT(finest, 0.02);
}

/// Reference S3, for k_θ L/EI = 100, 10, 1, 0.1 and (next to) 0. Mode 3 has no curvature at midspan. The
/// assembly is 2.7 % stiffer than the beam that it stands for, so the spring is measured by the assembly's
/// own E I, from its first eigenvalue 1.8751⁴ E I/(ρA L⁴); shear and rotary inertia, which the reference does
/// not have, are the rest.
TEST(Eigenmodes, CrackedCantilever) {
  constexpr double length = 40 * height;
  const std::vector<std::pair<double, std::array<double, 4>>> reference{
      {100, {.99519, .98009, .99998, .98077}},
      {10, {.95549, .83623, .99987, .85817}},
      {1, {.67604, .41679, .99948, .62117}},
      {0.1, {.16488, .22754, .99925, .54932}},
      {1e-6, {0, .20062, .99921, .53978}}};
  const Eigenmodes whole = cracked_cantilever(length, 0);
  const double euler = std::pow(1.87510407, 4) * young * height * height / 12 / std::pow(length, 4);
  const double stiffer = whole.values[0] / euler;
  EXPECT_NEAR(stiffer, 1, 0.03);
  constexpr double of_layer = 1 - 1.0 / 125;
  for (const auto& [spring, ratios] : reference) {
    const Eigenmodes cracked = cracked_cantilever(length, spring * stiffer * young / length / of_layer);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(cracked.values[i] / whole.values[i], ratios[i], 0.01 * std::max(ratios[i], 0.1))
          << "k_θ L/EI = " << spring << ", mode " << i + 1;
  }
}

/// Of a consistent joint that is released nothing is left, neither the stiffness that it subtracted: the
/// blocks are as stiff as one by itself.
TEST(Eigenmodes, ReleasedBlockIsWhole) {
  const auto deck = [](const std::string& second) {
    return R"(
scene:
  regions:
    - {material: concrete, vertices: [[0, 0], [100, 0], [100, 100], [0, 100]]}
)" + second +
           R"(
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 27500, poisson_ratio: 0.2}}
interfaces: {joint: {between: [concrete, concrete], law: {type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}}}
supports: {low: {at: [0, 0], fix: xy}, high: {at: [0, 100], fix: xy}}
stages: [{loads: [{type: point_load, at: [0, 0], force: [0, -1]}]}]
)";
  };
  const Structure two(
      deck("    - {material: concrete, vertices: [[100, 0], [200, 0], [200, 100], [100, 100]]}")),
      one(deck(""));
  System system(two.equilibrium, direct_solvers().choose("cholmod"), LinearSystem::Update::low_rank);
  std::vector<History> history(two.equilibrium.num_active());
  for (std::size_t p = 0; p < history.size(); ++p) {
    const InterfacePoint& point = two.equilibrium.point(p);
    history[p] = point.law->grown({}, point.stiffness, std::numeric_limits<double>::infinity());
  }
  system.set_history(history);
  std::vector<double> apart(two.equilibrium.num_unknowns(), 0.0);
  apart[6] = 1e-3;
  const State state{.d = std::move(apart)};
  const auto whole_modes = [&](bool is_physical) {
    return stiffness_modes(system, state, direct_solvers().choose("cholmod"),
                           {.count = 9, .mass = unit_mass(two.body), .is_physical = is_physical})
        ->modes.values;
  };
  const std::vector<double> physical = whole_modes(true), along_the_path = whole_modes(false);
  const double alone = modes_of(one, 1, true).values[0];
  EXPECT_NEAR(physical[3], alone, 1e-8 * alone);
  EXPECT_LT(along_the_path[3], 0.95 * alone);
}

/// K = K⁰ + Kᶜ + Kˢ + Kʷ.
TEST(Eigenmodes, ContributionsAddUp) {
  const Structure structure(row_of_blocks(3, 300, 200));
  const Equilibrium& equilibrium = structure.equilibrium;
  std::vector<Mat2> tangents(equilibrium.num_active(), Mat2(Vec2(-10, 3).asDiagonal()));
  const LinearSystem linear(equilibrium, direct_solvers().choose("cholmod"), LinearSystem::Update::low_rank);
  const Eigen::MatrixXd whole = dense(linear.matrix_with(tangents));
  for (std::size_t p = tangents.size(); p < equilibrium.num_points(); ++p)
    tangents.emplace_back(equilibrium.point(p).intact_stiffness().asDiagonal());
  const StiffnessParts parts = stiffness_parts(equilibrium, tangents);
  EXPECT_LT((parts.sum() - whole).cwiseAbs().maxCoeff(), 1e-14 * whole.cwiseAbs().maxCoeff());
  EXPECT_LT((dense(block_stiffness(equilibrium, tangents)) - whole).cwiseAbs().maxCoeff(),
            1e-14 * whole.cwiseAbs().maxCoeff());
  for (const Eigen::MatrixXd* part : {&parts.strain, &parts.contact, &parts.support, &parts.weak})
    EXPECT_GT(part->cwiseAbs().maxCoeff(), 0);
}

TEST(Eigenmodes, KrylovSchurEqualsDense) {
  const Structure structure(R"(
scene:
  regions: [{material: concrete, vertices: [[0, 0], [400, 0], [400, 100], [0, 100]]}]
  subdivision: {type: voronoi, blocks: 200, seed: 3}
thickness: 100
materials:
  concrete: {type: linear_elastic, young_modulus: 27500, poisson_ratio: 0.2}
interfaces:
  any: {between: [concrete, concrete], law: {type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}}
supports:
  left: {at: [0, 0], fix: xy}
  right: {at: [400, 0], fix: y}
stages: [{loads: [{type: point_load, at: [200, 100], force: [0, -1]}]}]
)");
  const Equilibrium& equilibrium = structure.equilibrium;
  LinearSystem linear(equilibrium, direct_solvers().choose("cholmod"), LinearSystem::Update::low_rank);
  std::vector<Mat2> tangents;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
    const Vec2 stiffness = equilibrium.point(p).intact_stiffness();
    const bool softens = p % 23 == 0 && p < 200;
    tangents.push_back((softens ? Vec2(-2 * stiffness.x(), 0.1 * stiffness.y()) : stiffness).asDiagonal());
  }
  ASSERT_TRUE(linear.set_tangent(tangents));
  const auto negative = linear.negative_eigenvalues().of_stiffness;
  ASSERT_TRUE(negative && *negative > 0);
  for (const bool with_mass : {true, false}) {
    EigenProblem problem{
        .solve = [&](auto b, auto x) { linear.solve(b, x); },
        .shifted = {},
        .mass = with_mass ? unit_mass(structure.body) : Mass::identity(equilibrium.num_nodes()),
        .count = 6,
        .num_negative = negative};
    const Eigen::MatrixXd k = dense(linear.matrix_with(tangents));
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> all(k, problem.mass.dense());
    EXPECT_EQ((all.eigenvalues().array() < 0).count(), *negative);
    const std::unique_ptr<DirectSolver> whole = direct_solvers().choose("cholmod").make();
    int shifts = 0;
    problem.shifted = [&](double shift) -> InverseOperator {
      BlockMatrix matrix = linear.matrix_with(tangents);
      problem.mass.add_to(matrix, shift);
      ++shifts;
      if (!whole->factor(matrix) || whole->num_negative_pivots() != 0) return {};
      return [&](auto b, auto x) {
        std::ranges::copy(b, x.begin());
        whole->solve(x, 1);
      };
    };
    const Eigenmodes found = lowest_eigenmodes(problem);
    EXPECT_GT(shifts, 0);
    for (int i = 0; i < 6; ++i) {
      const double expected = all.eigenvalues()[i], value = found.values[static_cast<std::size_t>(i)];
      EXPECT_NEAR(value, expected, 1e-8 * std::abs(expected)) << "mode " << i;
      const auto& shape = found.shapes[static_cast<std::size_t>(i)];
      EXPECT_NEAR(modal_assurance(shape, shape, problem.mass), 1, 1e-8);
      const Eigen::VectorXd column = all.eigenvectors().col(i);
      EXPECT_NEAR(modal_assurance(shape, {column.data(), shape.size()}, problem.mass), 1, 1e-6);
    }
  }
}

}  // namespace
}  // namespace dda::verification
