#include "studies/dda/record/measures.hpp"

#include <algorithm>
#include <array>

namespace dda {
namespace {

constexpr std::array fixed_names = {
    "step",          "load_factor",   "control", "newton_iterations", "dissipated_energy",
    "stored_energy", "external_work", "load"};

}  // namespace

std::string unit_of(Dimension dimension, const Units& units) {
  return dimension == dimension::none ? "" : label(dimension, units);
}

Measures::Measures(const Loading& loading, Functional load, std::string load_unit, const Units& units)
    : load_(std::move(load)),
      load_unit_(std::move(load_unit)),
      energy_unit_(unit_of(dimension::energy, units)) {
  for (const NamedGauge& gauge : loading.gauges) {
    if (gauge.dimension == dimension::length) displacements_.push_back(names_.size());
    add(gauge.name, gauge.dimension, gauge.functional, units);
  }
  num_gauges_ = names_.size();
  for (const auto& [name, reaction] : loading.reactions)
    add(is_taken(name) ? "reaction_" + name : name, dimension::force, reaction, units);
}

void Measures::add(const std::string& name, Dimension dimension, const Functional& functional,
                   const Units& units) {
  names_.push_back({is_taken(name) ? "gauge_" + name : name, unit_of(dimension, units)});
  functionals_.push_back(functional);
}

bool Measures::is_taken(const std::string& name) const {
  const bool is_indicator = name == "current_stiffness" || name == "rigid_modes" ||
                            name.starts_with("negative_") || name.starts_with("mu_") ||
                            name.starts_with("dissipated_energy_");
  return is_indicator || std::ranges::find(fixed_names, name) != fixed_names.end() ||
         std::ranges::find(names_, name, &Column::name) != names_.end();
}

std::vector<Column> Measures::columns() const {
  std::vector<Column> out;
  for (const std::string name : fixed_names) {
    const bool energy = name.ends_with("_energy") || name == "external_work";
    out.push_back({name, energy ? energy_unit_ : name == "load" ? load_unit_ : ""});
  }
  out.insert(out.end(), names_.begin(), names_.end());
  return out;
}

Measurement Measures::measure(const Walker& walker, int step, const std::string& control,
                              int newton_iterations) const {
  const Candidate& here = walker.here();
  Measurement out{.step = step,
                  .load_factor = here.state.load_factor,
                  .control = control,
                  .newton_iterations = newton_iterations,
                  .dissipated = here.dissipated,
                  .stored = here.stored,
                  .work = here.work,
                  .load = walker.value(load_),
                  .values = {}};
  for (const Functional& functional : functionals_) out.values.push_back(walker.value(functional));
  return out;
}

std::vector<TableCell> Measures::cells(const Measurement& m) {
  std::vector<TableCell> out{
      std::int64_t{m.step}, m.load_factor, m.control, std::int64_t{m.newton_iterations},
      m.dissipated,         m.stored,      m.work,    m.load};
  out.insert(out.end(), m.values.begin(), m.values.end());
  return out;
}

}  // namespace dda
