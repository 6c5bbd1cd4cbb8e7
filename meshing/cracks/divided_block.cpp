#include "meshing/cracks/divided_block.hpp"

#include <algorithm>
#include <limits>

#include "meshing/cracks/chord.hpp"

namespace dda {

bool DividedBlock::is_on_cut(const Vec2& x, double tolerance) const {
  return std::ranges::any_of(joints_, [&](const Joint& joint) {
    return distance(x, joint.start, joint.end) <= tolerance && (x - joint.start).norm() > tolerance &&
           (x - joint.end).norm() > tolerance;
  });
}

std::size_t DividedBlock::nearest(const Vec2& x) const {
  std::size_t out = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const double away = distance(x, parts_[i].outline);
    if (away >= least) continue;
    least = away;
    out = i;
  }
  return out;
}

const Part& DividedBlock::beside(const Vec2& x, const Vec2& direction) const {
  const Part* out = &parts_.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Part& part : parts_)
    for (std::size_t i = 0; i < part.outline.size(); ++i) {
      const Vec2 &a = part.outline.at(i), &b = part.outline.at(i + 1);
      const double away = distance(x, a, b);
      if (direction.dot(b - a) <= 0 || away >= least) continue;
      least = away;
      out = &part;
    }
  return *out;
}

std::vector<std::size_t> DividedBlock::beyond(std::size_t part, std::size_t joint) const {
  std::vector<std::size_t> found{part};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (j == joint || (joints_[j].left != found[i] && joints_[j].right != found[i])) continue;
      const std::size_t other = joints_[j].left == found[i] ? joints_[j].right : joints_[j].left;
      if (std::ranges::find(found, other) == found.end()) found.push_back(other);
    }
  return found;
}

bool DividedBlock::divide(JumpId jump, const Vec2& start, const Vec2& end, const Smallest& smallest) {
  const double tolerance = smallest.length;
  if (is_on_cut(start, tolerance)) return false;
  const auto part = std::ranges::find_if(
      parts_, [&](const Part& at) { return enters(at.outline, start, end - start, tolerance); });
  if (part == parts_.end()) return false;
  const auto exit = exit_of(part->outline, start, end - start, tolerance);
  if (!exit || (*exit - end).norm() > 2 * tolerance) return false;
  auto [left, right] = divided(part->outline, start, end, tolerance);
  if (!(signed_area(left) > smallest.area) || !(signed_area(right) > smallest.area)) return false;

  const auto old = static_cast<std::size_t>(part - parts_.begin()), added = parts_.size();
  for (Joint& joint : joints_) {
    const Vec2 middle = (joint.start + joint.end) / 2;
    const bool goes_right = distance(middle, right) < distance(middle, left);
    for (std::size_t* side : {&joint.left, &joint.right})
      if (*side == old && goes_right) *side = added;
  }
  parts_[old].outline = std::move(left);
  parts_.push_back({std::move(right), parts_[old].jumps});
  joints_.push_back({old, added, start, end});
  for (const std::size_t moved : beyond(added, joints_.size() - 1)) parts_[moved].jumps.push_back(jump);
  return true;
}

}  // namespace dda
