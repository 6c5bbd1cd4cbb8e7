#include "studies/dda/case/motion_columns.hpp"

#include <algorithm>

namespace dda::motion_column {

std::vector<Column> all(const Units& units, const std::vector<std::string>& interfaces) {
  const std::string energy = label(dimension::energy, units);
  std::vector<Column> out{{"step", ""},        {"time", "s"},       {"time_step", "s"}, {"iterations", ""},
                          {"meetings", ""},    {"live_joints", ""}, {work, energy},     {kinetic, energy},
                          {stored, energy},    {strain, energy},    {contact, energy},  {impacts, energy},
                          {friction, energy},  {fracture, energy},  {damping, energy},  {impact, energy},
                          {numerical, energy}, {error, energy}};
  for (const std::string& name : interfaces) out.push_back({std::string(fracture) + "_" + name, energy});
  return out;
}

void require_free(const Deck& deck, const std::vector<std::string>& interfaces) {
  const std::vector<Column> taken = all(deck.units, interfaces);
  Findings findings;
  for (const auto& [name, gauge] : deck.gauge_names)
    if (std::ranges::find(taken, name, &Column::name) != taken.end())
      findings.add(gauge.where(), "gauge '" + name +
                                      "' would be a second column of that name in motion.csv; "
                                      "choose another name");
  findings.throw_if_any();
}

}  // namespace dda::motion_column
