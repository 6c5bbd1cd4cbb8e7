#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "studies/dda/record/warnings/coarse_zones.hpp"
#include "studies/dda/record/warnings/torn_pieces.hpp"

namespace dda {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A plate of 12 × 4 squares of size 10, all joints of which can crack, l_ch = 100; places as given.
std::string plate(const std::string& supports, const std::string& load, const std::string& law) {
  return R"(title: A plate
units: {length: mm, force: N}
scene:
  regions: [{material: stone, vertices: [[0, 0], [120, 0], [120, 40], [0, 40]]}]
  subdivision: {type: grid, columns: 12, rows: 4}
thickness: 1
materials: {stone: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0.2}}
interfaces: {stone: {between: [stone, stone], law: )" +
         law + R"(}}
supports: )" +
         supports + R"(
stages: [{loads: [{type: point_load, )" +
         load + R"(, force: [0, -1]}]}]
)";
}

constexpr const char* points = "{left: {at: [0, 0], fix: xy}, right: {at: [115, 0], fix: y}}";
constexpr const char* patches =
    "{left: {over: [[0, 0], [40, 0]], fix: xy}, right: {over: [[80, 0], [120, 0]], fix: y}}";
constexpr const char* softening = "{type: linear_softening, tensile_strength: 3, fracture_energy: 0.03}";

class Plate {
 public:
  explicit Plate(const std::string& text) : deck_(deck_from_text(text, "plate.yaml", {})) {}
  const Simulation& operator*() const { return simulation_; }
  /// Every point of the sides of a block has lost its strength.
  void release(std::vector<History>& history, std::size_t block) const {
    const Equilibrium& equilibrium = simulation_.equilibrium();
    for (std::size_t p = 0; p < history.size(); ++p) {
      const InterfacePoint& point = equilibrium.point(p);
      if (point.first.value() == block || point.second.value() == block)
        history[p] = point.law->accept({1, 0}, {}, point.stiffness);
    }
  }
  std::vector<History> intact() const { return std::vector<History>(simulation_.equilibrium().num_active()); }

 private:
  Timings timings_;
  DeckFile deck_;
  Simulation simulation_{deck_.deck, timings_};
};

TEST(Tearing, PointsOnBlocksWhoseEverySideCanCrackAreWarnedOf) {
  const Plate plate_on_points(plate(points, "at: [55, 40]", softening));
  const auto warnings = tearing_warnings(*plate_on_points);
  ASSERT_THAT(warnings, SizeIs(3));
  EXPECT_THAT(warnings[0], HasSubstr("support 'left' at (0, 0) acts on one block of size 10 "));
  EXPECT_THAT(warnings[1], HasSubstr("`over: [[60, 0], [120, 0]]`"));
  EXPECT_THAT(warnings[2],
              testing::AllOf(HasSubstr("point_load at (55, 40)"), HasSubstr("40]"), HasSubstr("over:")));
}

TEST(Tearing, PatchesAndBondedBlocksAreNot) {
  EXPECT_THAT(tearing_warnings(*Plate(plate(patches, "over: [[40, 40], [80, 40]]", softening))), IsEmpty());
  EXPECT_THAT(tearing_warnings(*Plate(plate(points, "at: [55, 40]", "bonded"))), IsEmpty());
}

TEST(Tearing, ABlockCutOffUnderItsSupportIsFound) {
  const Plate on(plate(points, "at: [55, 40]", softening));
  std::vector<History> history = on.intact();
  EXPECT_THAT(torn_pieces(*on, history, true), IsEmpty());
  std::size_t corner = 0;
  for (std::size_t b = 0; b < 48; ++b)
    if ((*on).assembly().blocks[b].moments.centroid.isApprox(Vec2(5, 5))) corner = b;
  on.release(history, corner);
  const auto pieces = torn_pieces(*on, history, true);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_EQ(pieces[0].blocks, std::vector{BlockId(corner)});
  EXPECT_NEAR(pieces[0].share, 1, 1e-14);
  EXPECT_THAT(text(*on, pieces[0]), HasSubstr("support 'left' at (0, 0) has been torn out of the structure: "
                                              "100 % of all energy was spent around the block at (5, 5)"));
  EXPECT_EQ(to_json(*on, pieces)[0]["blocks"][0], corner);
}

TEST(Tearing, ACrackThroughTheStructureTearsNothingOut) {
  const Plate on(plate(points, "at: [55, 40]", softening));
  std::vector<History> history = on.intact();
  for (std::size_t p = 0; p < history.size(); ++p) {
    const InterfacePoint& point = (*on).equilibrium().point(p);
    if (std::abs(point.x.x() - 60) < 1e-9) history[p] = point.law->accept({1, 0}, {}, point.stiffness);
  }
  EXPECT_THAT(torn_pieces(*on, history, true), IsEmpty());
}

TEST(CoarseZones, SidesTooLongForTheSofteningAreTold) {
  EXPECT_THAT(coarse_zones(*Plate(plate(points, "at: [55, 40]", softening))), IsEmpty());
  const Plate brittle(
      plate(points, "at: [55, 40]", "{type: linear_softening, tensile_strength: 3, fracture_energy: 0.003}"));
  const auto zones = coarse_zones(*brittle);
  ASSERT_THAT(zones, SizeIs(1));
  EXPECT_NEAR(zones[0].side, 10, 1e-12);
  EXPECT_NEAR(zones[0].length, 10, 1e-12);
  EXPECT_THAT(text(*brittle, zones[0]),
              testing::AllOf(HasSubstr("interface 'stone'"), HasSubstr("sides of 3.3 mm")));
}

}  // namespace
}  // namespace dda
