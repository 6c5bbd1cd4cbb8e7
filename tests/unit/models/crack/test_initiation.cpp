#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/crack/initiation.hpp"
#include "support/cut_structure.hpp"

namespace dda {
namespace {

/// The beam [0, 30] × [0, 10] with σx = dead(x) + λ live(x) in its blocks.
struct Stressed {
  using Field = double (*)(const Vec2&);
  Stressed(Field dead, Field live) : structure({.subdivision = "{type: voronoi, blocks: 300, seed: 4}"}) {
    for (const Block& block : structure.assembly().blocks) {
      const Vec2& x = block.moments.centroid;
      stress.dead.emplace_back(dead(x), 0, 0);
      stress.live.emplace_back(live(x), 0, 0);
    }
  }
  std::vector<CrackStart> places(const LocalStrength& strength, const CrackStarts::Wish& wish = {}) {
    return CrackStarts(structure.cracks(), structure.body())
        .places(stress, {{{0, strength}}, wish.apart, wish.except});
  }
  std::vector<CrackStart> places(double strength, const CrackStarts::Wish& wish = {}) {
    return places(LocalStrength{strength}, wish);
  }

  CutStructure structure;
  BlockStress stress;
};

double none(const Vec2&) { return 0; }
double bent(const Vec2& x) { return 5 - x.y(); }
double pushed(const Vec2&) { return -1; }
/// Largest at x = 17; over three block sizes it bends by less than 1 %.
double peak(const Vec2& x) { return (5 - x.y()) * (1 - std::pow((x.x() - 17) / 40, 2)); }

TEST(CrackStarts, FindTheLoadAtWhichTheEdgeOfALinearFieldReachesTheStrength) {
  for (const CrackStart& place : Stressed(none, bent).places(2)) {
    if (place.at.y() > 1e-9) continue;
    EXPECT_NEAR(place.load_factor, 2 / 5.0, 1e-12);
    EXPECT_NEAR(place.direction.y(), 1, 1e-12) << "across the tension, into the body";
  }
  const auto places = Stressed(none, bent).places(2);
  ASSERT_FALSE(places.empty());
  EXPECT_NEAR(places.front().at.y(), 0, 1e-9);
}

TEST(CrackStarts, CountWhatIsThereWithoutLoad) {
  EXPECT_NEAR(Stressed(pushed, bent).places(2).front().load_factor, 3 / 5.0, 1e-12);
  EXPECT_EQ(Stressed(bent, none).places(2).front().load_factor, 0) << "beyond the strength already";
  EXPECT_TRUE(Stressed(none, pushed).places(2).empty()) << "never";
}

TEST(CrackStarts, TakeThePlaceOfTheLargestTensionFirst) {
  Stressed beam(none, peak);
  const CrackStart first = beam.places(2).front();
  const double h = beam.structure.cracks().block_size();
  EXPECT_NEAR(first.at.x(), 17, h);
  EXPECT_NEAR(first.at.y(), 0, 1e-9);
  EXPECT_NEAR(first.load_factor, 2 / 5.0, 0.01 * 2 / 5);
}

/// Tension is the same all along the edge: where the field is weakest the least load does.
TEST(CrackStarts, HaveTheStrengthOfTheFieldAtTheirPlace) {
  const RandomField field({.coefficient_of_variation = 0.3, .correlation_length = 4, .seed = 3});
  const auto places = Stressed(none, bent).places({2, &field});
  double least = std::numeric_limits<double>::infinity();
  for (const CrackStart& place : places) {
    if (place.at.y() > 1e-9) continue;
    const double wanted = 2 * field.factor(place.at) / 5;
    EXPECT_NEAR(place.load_factor, wanted, 1e-12);
    least = std::min(least, wanted);
  }
  ASSERT_FALSE(places.empty());
  EXPECT_LE(places.front().load_factor, least) << "the weakest place first";
  EXPECT_LT(least, 0.9 * 2 / 5);
}

TEST(CrackStarts, KeepAwayFromOtherCracks) {
  Stressed beam(none, peak);
  ASSERT_GT(beam.structure.cut_straight({16.7, 0}, {0, 1}, 3), 0);
  const CrackStart next = beam.places(2, {{}, 4, {}}).front();
  EXPECT_GE(std::abs(next.at.x() - 16.7), 4);
  EXPECT_LT(std::abs(next.at.x() - 16.7), 4 + beam.structure.cracks().block_size());
  EXPECT_NEAR(beam.places(2, {{}, 4, 0}).front().at.x(), 17, 1) << "but from the one that may move";
}

}  // namespace
}  // namespace dda
