#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "meshing/geometry/box_grid.hpp"

namespace dda {
namespace {

std::vector<Box> random_boxes() {
  std::vector<Box> boxes;
  for (int n = *rc::gen::inRange(0, 40); n > 0; --n) {
    const Vec2 low(*rc::gen::inRange(0, 50), *rc::gen::inRange(0, 50));
    boxes.push_back({low, low + Vec2(*rc::gen::inRange(0, 12), *rc::gen::inRange(0, 40))});
  }
  return boxes;
}

RC_GTEST_PROP(BoxGrid, FindsEachTouchingPairOnce, ()) {
  const std::vector<Box> boxes = random_boxes();
  std::multiset<std::pair<std::size_t, std::size_t>> expected, found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (boxes[i].touches(boxes[j])) expected.emplace(i, j);
  BoxGrid(boxes).for_each_pair(
      [&](std::size_t i, std::size_t j) { found.emplace(std::min(i, j), std::max(i, j)); });
  RC_ASSERT(found == expected);
}

RC_GTEST_PROP(BoxGrid, FindsEachHitOnce, ()) {
  const std::vector<Box> boxes = random_boxes();
  const Box query{Vec2(*rc::gen::inRange(-20, 60), *rc::gen::inRange(-20, 60)), Vec2(70, 70)};
  std::multiset<std::size_t> expected, found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].touches(query)) expected.insert(i);
  BoxGrid(boxes).for_each_hit(query, [&](std::size_t i) { found.insert(i); });
  RC_ASSERT(found == expected);
}

}  // namespace
}  // namespace dda
