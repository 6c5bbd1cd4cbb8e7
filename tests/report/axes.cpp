#include <iostream>
#include <nlohmann/json.hpp>

#include "framework/figure/axis.hpp"
#include "framework/figure/style.hpp"

/// Axes of the ranges [[low, high, wanted ticks, logarithmic?], ...] that it reads, for the comparison with those of the page.
int main() {
  using namespace dda::svg;
  nlohmann::json out;
  for (const auto& range : nlohmann::json::parse(std::cin)) {
    const Range ends{range[0], range[1], false};
    const Axis axis = range[3].get<bool>() ? make_logarithmic_axis(ends, range[2]) : make_axis(ends, range[2]);
    nlohmann::json labels = nlohmann::json::array();
    for (const Tick& tick : axis.ticks) labels.push_back(tick.label);
    const Range wide = axis.range.widened(axis_margin);
    const double length = axis.range.high - axis.range.low;
    out.push_back(
        {{"labels", labels}, {"scale", axis.scale}, {"numbers", {wide.low, wide.high, round_down(length)}}});
    for (const Tick& tick : axis.ticks) out.back()["numbers"].push_back(tick.value);
  }
  std::cout << out;
}
