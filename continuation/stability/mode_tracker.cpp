#include "continuation/stability/mode_tracker.hpp"

#include <algorithm>
#include <ranges>

namespace dda {

std::vector<int> ModeTracker::follow(const Eigenmodes& present, const Mass& mass) {
  struct Pair {
    double alike;
    std::size_t tracked, present;
  };
  std::vector<Pair> pairs;
  constexpr double half = 0.5;
  for (std::size_t t = 0; t < known_.shapes.size(); ++t)
    for (std::size_t i = 0; i < present.shapes.size(); ++i)
      if (const double alike = modal_assurance(known_.shapes[t], present.shapes[i], mass); alike > half)
        pairs.push_back({alike, t, i});
  std::ranges::stable_sort(pairs, std::ranges::greater{}, &Pair::alike);
  std::vector<int> out(known_.shapes.size(), -1);
  for (const Pair& pair : pairs) {
    const int place = static_cast<int>(pair.present);
    if (out[pair.tracked] >= 0 || std::ranges::find(out, place) != out.end()) continue;
    out[pair.tracked] = place;
    known_.shapes[pair.tracked] = present.shapes[pair.present];
  }
  return out;
}

}  // namespace dda
