#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "continuation/path/path.hpp"
#include "studies/dda/record/measures.hpp"

namespace dda {

/// Depth below which limit points and turning points are counted, not listed: of the largest load, and of the
/// largest displacement of a gauge.
inline constexpr double listed_depth = turn_depth;

/// The events of a path without its small extrema, and how many of each quantity those are.
struct ListedEvents {
  nlohmann::ordered_json listed;
  nlohmann::ordered_json small;  ///< {"depth": 0.005, "load": 64, "cmod": 3}; null when there are none
};

/// Leaves out the limit points and turning points that single blocks make: as long as two extrema of a
/// quantity that follow each other, or one and an end of the path, differ by less than that depth, those of
/// the least difference are taken out. Loads of one stage do not follow those of another. The largest stays. Other events stay. `names` are those of the values
/// of a measurement.
ListedEvents listed_events(const nlohmann::ordered_json& events, const Measurement& start,
                           const Measurement& end, const std::vector<Column>& names);

}  // namespace dda
