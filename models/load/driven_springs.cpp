#include "models/load/driven_springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dda {

double sense_of(const Functional& one, const Functional& other) {
  constexpr double same = 1e-9;
  if (one.rows.size() != other.rows.size()) return 0;
  double product = 0, difference[2] = {0, 0}, square = 0;
  for (std::size_t r = 0; r < one.rows.size(); ++r) {
    if (one.rows[r].first != other.rows[r].first) return 0;
    const Vec6 &a = one.rows[r].second, &b = other.rows[r].second;
    product += a.dot(b);
    square += a.squaredNorm();
    difference[0] += (a - b).squaredNorm();
    difference[1] += (a + b).squaredNorm();
  }
  const double sense = product < 0 ? -1 : 1;
  return difference[sense < 0] <= same * same * square ? sense : 0;
}

DrivenSprings::Known DrivenSprings::find(const DrivenSpring& driven) const {
  for (std::size_t s = 0; s < springs_.size(); ++s)
    if (const double sense = sense_of(springs_[s].displacement, driven.displacement); sense != 0)
      return {s, sense};
  return {};
}

std::string DrivenSprings::name_along(const Vec2& direction) {
  constexpr double same = 1e-9;
  const auto known = std::ranges::find_if(directions_, [&](const Vec2& other) {
    return std::abs(other.x() * direction.y() - other.y() * direction.x()) < same;
  });
  const auto index = known - directions_.begin();
  if (known == directions_.end()) directions_.push_back(direction);
  return index == 0 ? "driven" : fmt::format("driven_{}", index + 1);
}

void DrivenSprings::go_on(std::size_t stage, const Known& known, DrivenSpring& driven) {
  const std::string& name = springs_[known.spring].name;
  if (stages_[known.spring] == stage)
    throw InputError(driven.where, "is driven along this direction by another load of the stage; keep one");
  if (!driven.name.empty() && driven.name != name)
    throw InputError(
        driven.where,
        fmt::format("name: an earlier stage drives this along the same direction under the name '{0}'; "
                    "it goes on as '{0}', or without a name",
                    name));
  driven.name = name;
  driven.spring = known.spring;
  driven.sense = known.sense;
  stages_[known.spring] = stage;
}

void DrivenSprings::place(std::size_t stage, std::span<DrivenSpring> of_load) {
  const std::size_t first = springs_.size();
  std::string name;
  for (DrivenSpring& driven : of_load) {
    if (const Known known = find(driven); known.sense != 0 && known.spring < first) {
      go_on(stage, known, driven);
      continue;
    }
    if (driven.name.empty()) driven.name = name.empty() ? name = name_along(driven.direction) : name;
    driven.spring = springs_.size();
    springs_.push_back(driven);
    stages_.push_back(stage);
  }
}

}  // namespace dda
