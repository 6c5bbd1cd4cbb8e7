// The consistent interface is stable for α > ½ on any blocks, and free of locking.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "verification/assemblies.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

/// A stack of regions, each cut by the drawing's subdivision, pinned at two corners.
struct Stack {
  Drawing drawing;
  double ratio = 1;  ///< Young's modulus of the material `stiff` over that of `soft`
  double poisson = 0.2;
  bool plane_strain = false;

  std::string deck(const std::string& treatment) const {
    const auto at = [&](std::size_t i) {
      const Vec2& x = drawing.outline.at(i);
      return fmt::format("[{:.17g}, {:.17g}]", x.x(), x.y());
    };
    return scene_text(drawing) + fmt::format(R"(
thickness: 1
plane: {}
weak_springs: 0
support_stiffness: 1
materials:
  soft: {{type: linear_elastic, young_modulus: 1, poisson_ratio: {}}}
  stiff: {{type: linear_elastic, young_modulus: {}, poisson_ratio: {}}}
interfaces:
  soft_soft: {{between: [soft, soft], treatment: {}}}
  soft_stiff: {{between: [soft, stiff], treatment: {}}}
  stiff_stiff: {{between: [stiff, stiff], treatment: {}}}
supports:
  pin: {{at: {}, fix: xy}}
  roller: {{at: {}, fix: y}}
stages: [{{loads: [{{type: edge_traction, boundary: side0, traction: [0, 1]}}]}}]
)",
                                             plane_strain ? "strain" : "stress", poisson, ratio, poisson,
                                             treatment, treatment, treatment, at(0), at(1));
  }
  double smallest_eigenvalue(double alpha) const {
    const Structure structure(deck(fmt::format("{{type: consistent, alpha: {}}}", alpha)));
    return smallest_scaled_eigenvalue(structure.equilibrium.intact());
  }
};

void PrintTo(const Stack& stack, std::ostream* out) {
  *out << stack.drawing.name << ", ratio " << stack.ratio << ", nu " << stack.poisson
       << (stack.plane_strain ? ", plane strain" : "");
}

Stack voronoi(std::uint64_t seed) {
  const Polygon outline = rectangle({0, 0}, {3, 2});
  return {{fmt::format("random Voronoi {}", seed),
           {{"soft", outline}},
           outline,
           fmt::format("{{type: voronoi, blocks: 60, seed: {}, iterations: 0}}", seed)}};
}

/// `layers` layers of blocks `slenderness` times as long as high; every second one may be stiff.
Stack layers(int layers, double slenderness, const std::string& shape, double ratio) {
  Stack out{{fmt::format("slender {} {}:1", shape, slenderness),
             {},
             rectangle({0, 0}, {slenderness, 1.0 * layers})}};
  for (int i = 0; i < layers; ++i)
    out.drawing.regions.emplace_back(ratio != 1 && i % 2 == 1 ? "stiff" : "soft",
                                     rectangle({0, 1.0 * i}, {slenderness, i + 1.0}));
  out.drawing.subdivision = fmt::format("{{type: grid, columns: 1, rows: 1, shape: {}}}", shape);
  out.ratio = ratio;
  return out;
}

/// Random convex pieces with T-joints, stiff and soft in turn.
Stack unlike_polygons(std::uint64_t seed, double ratio) {
  const Polygon outline = random_convex(6, {2, 1}, seed);
  Stack out{{fmt::format("random polygons {}", seed), {}, outline}};
  for (Polygon& piece : random_pieces(outline, 40, seed))
    out.drawing.regions.emplace_back(out.drawing.regions.size() % 2 == 0 ? "soft" : "stiff",
                                     std::move(piece));
  out.ratio = ratio;
  return out;
}

std::vector<Stack> any_blocks() {
  std::vector<Stack> out;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    out.push_back(voronoi(seed));
    out.push_back(unlike_polygons(seed, 1));
    out.push_back(unlike_polygons(seed, 1e6));
  }
  for (const std::string shape : {"quads", "triangles"})
    for (const double ratio : {1.0, 1e6}) {
      out.push_back(layers(12, 10, shape, ratio));
      out.push_back(layers(12, 1000, shape, ratio));
    }
  const std::size_t in_plane_stress = out.size();
  for (std::size_t i = 0; i < in_plane_stress; i += 3) {
    Stack stack = out[i];
    stack.plane_strain = true;
    stack.poisson = 0.4;
    out.push_back(stack);
  }
  return out;
}

TEST(StabilityBound, IsSufficientForAnyBlocks) {
  for (const Stack& stack : any_blocks())
    EXPECT_GT(stack.smallest_eigenvalue(0.51), 0) << testing::PrintToString(stack);
}

TEST(StabilityBound, IsSharpForSlenderStacks) {
  for (const std::string shape : {"quads", "triangles"})
    for (const double slenderness : {100.0, 1000.0}) {
      const Stack stack = layers(24, slenderness, shape, 1);
      EXPECT_LT(stack.smallest_eigenvalue(0.45), 0) << stack.drawing.name;
      for (const double alpha : {0.5, 0.505, 0.51, 0.6})
        EXPECT_GT(stack.smallest_eigenvalue(alpha), 0) << stack.drawing.name << ", alpha " << alpha;
    }
}

/// A soft layer between two slabs; the lower is held, the upper pulled or pushed sideways.
struct Sandwich {
  double ratio = 1;
  int columns = 20, rows_in_layer = 1, rows_in_slab = 4;
  Vec2 traction = Vec2(0, 1);

  std::string deck() const {
    const auto part = [](double low, double high) {
      return points_text(rectangle({0, low}, {100, high}).vertices);
    };
    std::string regions;
    const auto add = [&](const std::string& material, double low, double high, int rows) {
      for (int i = 0; i < rows; ++i)
        regions += fmt::format("    - {{material: {}, vertices: {}}}\n", material,
                               part(low + (high - low) * i / rows, low + (high - low) * (i + 1) / rows));
    };
    add("stiff", 0, 20, rows_in_slab);
    add("soft", 20, 25, rows_in_layer);
    add("stiff", 25, 45, rows_in_slab);
    return fmt::format(R"(
scene:
  regions:
{}
  boundaries: {{bottom: [[0, 0], [100, 0]], top: [[100, 45], [0, 45]]}}
  subdivision: {{type: grid, columns: {}, rows: 1}}
thickness: 1
materials:
  soft: {{type: linear_elastic, young_modulus: 1, poisson_ratio: 0.2}}
  stiff: {{type: linear_elastic, young_modulus: {}, poisson_ratio: 0.2}}
supports: {{ground: {{boundary: bottom, fix: xy}}}}
stages: [{{loads: [{{type: edge_traction, boundary: top, traction: [{}, {}]}}]}}]
)",
                       regions, columns, ratio, traction.x(), traction.y());
  }
  /// Work of the load, twice the stored energy.
  double compliance() const {
    const Structure structure(deck());
    const auto d = intact_response(structure.equilibrium);
    const auto& force = structure.equilibrium.stages().back().reference;
    return std::inner_product(d.begin(), d.end(), force.begin(), 0.0);
  }
};

class SoftLayer : public testing::TestWithParam<double> {};

TEST_P(SoftLayer, OfOneBlockKeepsItsCompliance) {
  for (const Vec2& traction : {Vec2(0, 1), Vec2(1, 0)}) {
    const Sandwich coarse{.ratio = GetParam(), .traction = traction};
    const Sandwich fine{
        .ratio = GetParam(), .columns = 80, .rows_in_layer = 8, .rows_in_slab = 8, .traction = traction};
    const double share = coarse.compliance() / fine.compliance();
    EXPECT_GT(share, 0.97) << "traction " << traction.transpose();
    EXPECT_LT(share, 1.03) << "traction " << traction.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(StiffnessRatios, SoftLayer, testing::Values(1.0, 1e2, 1e4, 1e6));

}  // namespace
}  // namespace dda::verification
