#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>

#include "meshing/geometry/voronoi.hpp"

namespace dda {
namespace {

const Figure plate{{{{0, 0}, {4, 0}, {4, 1}, {0, 1}}}, {}};
const Figure angle_plate{{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}, {}};
const Figure frame{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, {{{{1, 1}, {3, 1}, {3, 3}, {1, 3}}}}};

double total(const std::vector<Polygon>& cells) {
  double sum = 0;
  for (const Polygon& cell : cells) sum += signed_area(cell);
  return sum;
}

RC_GTEST_PROP(Voronoi, CellsFillTheFigure, ()) {
  const auto& figure = *rc::gen::element(plate, angle_plate, frame);
  const VoronoiWish wish{static_cast<std::size_t>(*rc::gen::inRange(1, 60)),
                         static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)), *rc::gen::inRange(0, 6)};
  const std::vector<Polygon> cells = centroidal_voronoi(figure, wish);
  RC_ASSERT(cells.size() >= wish.blocks);
  RC_ASSERT(std::abs(total(cells) - area(figure)) < 1e-9);
  for (const Polygon& cell : cells) RC_ASSERT(!defect(cell));
}

TEST(Voronoi, AConvexFigureGivesOneConvexCellPerSite) {
  for (const std::size_t blocks : {1u, 2u, 3u, 7u, 130u, 455u}) {
    const auto cells = centroidal_voronoi(plate, {blocks, 4, 5});
    EXPECT_EQ(cells.size(), blocks);
    for (const Polygon& cell : cells) EXPECT_TRUE(is_convex(cell));
  }
}

TEST(Voronoi, ASeedGivesTheSameCellsAgainAndAnotherSeedOthers) {
  const auto a = centroidal_voronoi(angle_plate, {50, 7, 10}),
             b = centroidal_voronoi(angle_plate, {50, 7, 10});
  const auto c = centroidal_voronoi(angle_plate, {50, 8, 10});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].vertices, b[i].vertices);
  EXPECT_NE(a[0].vertices, c[0].vertices);
}

TEST(Voronoi, LloydEvensOutTheAreas) {
  const auto spread = [](int iterations) {
    double squares = 0;
    for (const Polygon& cell : centroidal_voronoi(plate, {100, 1, iterations}))
      squares += std::pow(signed_area(cell), 2);
    return squares;
  };
  EXPECT_LT(spread(20), 0.9 * spread(0));
}

TEST(Voronoi, CellsAreThoseOfTheNearestSite) {
  const std::vector<Vec2> sites{{0.1, 0.2}, {0.9, 0.3}, {0.4, 0.8}, {0.6, 0.1}};
  const std::vector<Polygon> cells = voronoi_cells(sites, {Vec2(0, 0), Vec2(1, 1)});
  for (double x = 0.05; x < 1; x += 0.1)
    for (double y = 0.05; y < 1; y += 0.1) {
      const auto nearest = std::min_element(sites.begin(), sites.end(), [&](const Vec2& a, const Vec2& b) {
        return (a - Vec2(x, y)).norm() < (b - Vec2(x, y)).norm();
      });
      for (const Polygon& cell : cells)
        EXPECT_TRUE(!contains(cell, *nearest, 0) || contains(cell, {x, y}, 1e-9));
    }
}

TEST(Voronoi, CountsAreSharedByArea) {
  EXPECT_EQ(share(10, {1, 1, 2}), (std::vector<std::size_t>{3, 2, 5}));
  EXPECT_EQ(share(4, {100, 1, 1}), (std::vector<std::size_t>{3, 1, 1}));
  const auto many = share(455, {1.5, 2.5, 7.25});
  EXPECT_EQ(std::accumulate(many.begin(), many.end(), std::size_t{0}), 455u);
}

TEST(Voronoi, CutCellsFollowALineThatEndsInside) {
  const std::vector<Polygon> cells{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {{{1, 0}, {2, 0}, {2, 1}, {1, 1}}}};
  const auto parts = cut_cells(cells, {{{-1, 0.5}, {0.5, 0.5}}});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(signed_area(parts[0]), 0.5, 1e-12);
  EXPECT_NEAR(total(parts), 2, 1e-12);
  EXPECT_EQ(cut_cells(cells, {{{1, -1}, {1, 2}}}).size(), 2u);
}

RC_GTEST_PROP(Squares, FillTheFigureAtAnyAngle, ()) {
  const auto& figure = *rc::gen::element(plate, angle_plate, frame);
  const double size = *rc::gen::element(0.13, 0.31, 0.7, 5.0), angle = 0.01 * *rc::gen::inRange(-314, 315);
  const std::vector<Polygon> cells = square_cells(figure, size, angle);
  RC_ASSERT(std::abs(total(cells) - area(figure)) < 1e-9);
  for (const Polygon& cell : cells) RC_ASSERT(!defect(cell));
}

TEST(Squares, AreSquaresInTheMiddleAndNoSliversAtTheOutline) {
  const double size = 0.1, angle = 0.5;
  const Vec2 along(std::cos(angle), std::sin(angle));
  int whole = 0;
  for (const Polygon& cell : square_cells(plate, size, angle)) {
    EXPECT_GT(signed_area(cell), size * size / 8);
    if (std::abs(signed_area(cell) - size * size) > 1e-6 * size * size) continue;
    ++whole;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Vec2 edge = (cell.at(i + 1) - cell.at(i)) / size;
      EXPECT_NEAR(std::abs(cross(along, edge) * along.dot(edge)), 0, 1e-6) << "sites are off by 1e-7";
    }
  }
  EXPECT_GT(whole, 280) << "of 400";
}

}  // namespace
}  // namespace dda
