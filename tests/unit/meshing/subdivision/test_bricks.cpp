#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

/// A wall of 6 × 1.2 in bricks; what more stands in its subdivision.
std::string wall(const std::string& more,
                 const std::string& vertices = "[[0, 0], [6, 0], [6, 1.2], [0, 1.2]]") {
  return "{regions: [{material: brick, vertices: " + vertices +
         "}], subdivision: {type: bricks, length: 1, height: 0.3, " + more + "}}";
}

/// Lengths of the bricks of each course from left to right, by hundredths.
std::vector<std::vector<int>> courses(const Assembly& wall, double height = 0.3) {
  std::map<int, std::map<double, int>> found;
  for (const Block& block : wall.blocks) {
    const Box box = bounding_box(block.outline.vertices);
    const auto course = static_cast<int>(std::floor(block.moments.centroid.y() / height));
    found[course][box.low.x()] = static_cast<int>(std::lround(100 * (box.high.x() - box.low.x())));
  }
  std::vector<std::vector<int>> out;
  for (const auto& [course, bricks] : found) {
    out.emplace_back();
    for (const auto& [x, length] : bricks) out.back().push_back(length);
  }
  return out;
}

using Course = std::vector<int>;
using testing::ElementsAre;

TEST(Bricks, InRunningBondEverySecondCourseIsMovedByHalfABrick) {
  const Course whole(6, 100), moved{50, 100, 100, 100, 100, 100, 50};
  EXPECT_THAT(courses(mesh_of(wall("bond: running"))), ElementsAre(whole, moved, whole, moved));
  EXPECT_EQ(courses(mesh_of(wall(""))), courses(mesh_of(wall("bond: running, overlap: 0.5"))));
  const Course third{67, 100, 100, 100, 100, 100, 33};
  EXPECT_THAT(courses(mesh_of(wall("overlap: 0.3333"))), ElementsAre(whole, third, whole, third));
}

TEST(Bricks, CoursesMayBeSaidOneByOne) {
  const Assembly given =
      mesh_of(wall("courses: [{lengths: [1, 0.5]}, {lengths: [0.75], offset: -0.25}, {lengths: [3]}]",
                   "[[0, 0], [3, 0], [3, 1.2], [0, 1.2]]"));
  EXPECT_THAT(courses(given), ElementsAre(Course{100, 50, 100, 50}, Course{50, 75, 75, 75, 25}, Course{300},
                                          Course{100, 50, 100, 50}));
  EXPECT_EQ(mesh_of(wall("courses: [{height: 0.4}, {height: 0.2, offset: -0.5}]")).num_blocks(),
            6u + 7 + 6 + 7);
}

TEST(Bricks, CoursesOrABond) {
  try {
    mesh_of(wall("bond: stack, courses: [{lengths: [1]}]"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("`courses` say how their bricks lie"));
  }
}

TEST(Bricks, InStackBondJointsAreAboveEachOther) {
  EXPECT_THAT(courses(mesh_of(wall("bond: stack"))), testing::Each(Course(6, 100)));
}

TEST(Bricks, InFlemishBondHeadersAreAboveTheMiddleOfStretchers) {
  const Course even{100, 50, 100, 50, 100, 50, 100, 50}, odd{25, 50, 100, 50, 100, 50, 100, 50, 75};
  EXPECT_THAT(courses(mesh_of(wall("bond: flemish"))), ElementsAre(even, odd, even, odd));
  const Course long_headers{100, 60, 100, 60, 100, 60, 100, 20};
  EXPECT_EQ(courses(mesh_of(wall("bond: flemish, header: 0.6")))[0], long_headers);
}

TEST(Bricks, InEnglishBondCoursesOfStretchersAndHeadersTakeTurns) {
  Course headers(11, 50);
  headers.insert(headers.begin(), 25);
  headers.push_back(25);
  EXPECT_THAT(courses(mesh_of(wall("bond: english"))),
              ElementsAre(Course(6, 100), headers, Course(6, 100), headers));
}

TEST(Bricks, BeginAtTheOriginAndGoOnEitherSide) {
  const Course begun{20, 100, 100, 100, 100, 100, 80};
  EXPECT_THAT(courses(mesh_of(wall("bond: stack, origin: [3.2, 0.6]"))), testing::Each(begun));
  EXPECT_EQ(courses(mesh_of(wall("origin: [3, 0.3]")))[0], (Course{50, 100, 100, 100, 100, 100, 50}));
}

TEST(Bricks, MeetEachOtherAllAroundAndTheOutline) {
  // An opening, and a sloping top.
  const Assembly a =
      mesh_of(wall("bond: flemish",
                   "[[0, 0], [2, 0], [2, 0.5], [3.3, 0.5], [3.3, 0], [6, 0], [6, 1.1], [3, 1.7], [0, 1.2]]"));
  EXPECT_NEAR(total_area(a), 3 * (1.2 + 1.7) / 2 + 3 * (1.7 + 1.1) / 2 - 1.3 * 0.5, 1e-9);
  EXPECT_LT(uncovered_perimeter(a), 1e-9);
}

TEST(Bricks, NoSliversAreLeftByRoundOff) {
  // 0.1 and 0.3 have no exact binary form.
  const Assembly a = mesh_of(
      "{regions: [{material: brick, vertices: [[0.1, 0.2], [2.2, 0.2], [2.2, 1.1], [0.1, 1.1]]}], "
      "subdivision: {type: "
      "bricks, length: 0.3, height: 0.1, bond: stack}}");
  EXPECT_EQ(a.num_blocks(), 7u * 9u);
}

TEST(Bricks, KeysHaveToFitTheBond) {
  EXPECT_THAT(complaint(wall("header: 0.4")),
              testing::HasSubstr("'header' belongs to flemish and english bond"));
  EXPECT_THAT(complaint(wall("bond: stack, overlap: 0.5")),
              testing::HasSubstr("'overlap' belongs to running bond"));
  EXPECT_THAT(complaint(wall("bond: flemisch")), testing::HasSubstr("did you mean 'flemish'?"));
}

}  // namespace
}  // namespace dda
