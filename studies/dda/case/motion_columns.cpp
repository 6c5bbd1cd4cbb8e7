#include "studies/dda/case/motion_columns.hpp"

#include <algorithm>

namespace dda::motion_column {

std::vector<Column> all(const Units& units) {
  const std::string energy = label(dimension::energy, units);
  return {{"step", ""},     {"time", "s"},       {"time_step", "s"}, {"iterations", ""},
          {"meetings", ""}, {"live_joints", ""}, {work, energy},     {kinetic, energy},
          {stored, energy}, {friction, energy},  {fracture, energy}, {numerical, energy},
          {error, energy}};
}

void require_free(const Deck& deck) {
  const std::vector<Column> taken = all(deck.units);
  Findings findings;
  for (const auto& [name, gauge] : deck.gauge_names)
    if (std::ranges::find(taken, name, &Column::name) != taken.end())
      findings.add(gauge.where(), "gauge '" + name +
                                      "' would be a second column of that name in motion.csv; "
                                      "choose another name");
  findings.throw_if_any();
}

}  // namespace dda::motion_column
