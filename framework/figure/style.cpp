#include "framework/figure/style.hpp"

#include <nlohmann/json.hpp>

#include "framework/figure/colour_map.hpp"

namespace dda::svg {
namespace {

nlohmann::ordered_json steps_of(ColourMap map) {
  nlohmann::ordered_json out;
  for (int i = 0; i < colour_steps; ++i) out.push_back(colour(map, (i + 0.5) / colour_steps));
  return out;
}

}  // namespace

nlohmann::ordered_json page_style() {
  return {{"palette", palette},
          {"tints", tints},
          {"paper", paper},
          {"ink", ink},
          {"faint", faint},
          {"grey", grey},
          {"blockFill", block_fill},
          {"blockEdge", block_edge},
          {"markOutline", mark_outline},
          {"hairline", hairline},
          {"dashes", dashes},
          {"dots", dots},
          {"maps",
           {{"viridis", steps_of(ColourMap::viridis)},
            {"crack", steps_of(ColourMap::crack)},
            {"signed", steps_of(ColourMap::violet_to_green)}}},
          {"minorTick", minor_tick},
          {"axisMargin", axis_margin},
          {"leastLength", least_length},
          {"halfOfNoLength", half_of_no_length},
          {"roundDigits", round_digits},
          {"rounding", rounding},
          {"tickSlack", tick_slack},
          {"largeExponent", large_exponent},
          {"smallExponent", small_exponent},
          {"mostSteps", most_steps}};
}

}  // namespace dda::svg
