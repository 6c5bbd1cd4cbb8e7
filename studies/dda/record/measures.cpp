#include "studies/dda/record/measures.hpp"

#include <algorithm>

namespace dda {
std::string unit_of(Dimension dimension, const Units& units) {
  return dimension == dimension::none ? "" : label(dimension, units);
}

Measures::Measures(const Loading& loading, Functional load, std::string load_unit, const Units& units,
                   const RecordedColumns& others)
    : load_(std::move(load)),
      load_unit_(std::move(load_unit)),
      energy_unit_(unit_of(dimension::energy, units)) {
  const RecordedColumns own = path_columns();
  const auto is_taken = [&](const std::string& name) {
    const auto takes = [&](const RecordedColumn& column) { return column.takes(name); };
    return name == column::stage || std::ranges::any_of(own, takes) || std::ranges::any_of(others, takes) ||
           std::ranges::find(names_, name, &Column::name) != names_.end();
  };
  const auto add = [&](const std::string& name, Dimension dimension, const Functional& functional) {
    names_.push_back({is_taken(name) ? "gauge_" + name : name, unit_of(dimension, units)});
    functionals_.push_back(functional);
  };
  for (const NamedGauge& gauge : loading.gauges) {
    if (gauge.dimension == dimension::length) displacements_.push_back(names_.size());
    add(gauge.name, gauge.dimension, gauge.functional);
  }
  num_gauges_ = names_.size();
  for (const auto& [name, reaction] : loading.reactions)
    add(is_taken(name) ? "reaction_" + name : name, reaction.is_moment ? dimension::moment : dimension::force,
        reaction);
}

RecordedColumns Measures::path_columns() const {
  using At = const RecordedStep&;
  return {{{column::step, ""}, [](At at) { return std::int64_t{at.now.step}; }},
          {{column::load_factor, ""}, [](At at) { return at.now.load_factor; }},
          {{"control", ""}, [](At at) { return at.now.control; }},
          {{"newton_iterations", ""}, [](At at) { return std::int64_t{at.now.newton_iterations}; }},
          {{column::dissipated_energy, energy_unit_}, [](At at) { return at.now.dissipated; }},
          {{column::stored_energy, energy_unit_}, [](At at) { return at.now.stored; }},
          {{column::external_work, energy_unit_}, [](At at) { return at.now.work; }},
          {{column::load, load_unit_}, [](At at) { return at.now.load; }}};
}

RecordedColumns Measures::columns() const {
  RecordedColumns out = path_columns();
  for (std::size_t i = 0; i < names_.size(); ++i)
    out.push_back({names_[i], [i](const RecordedStep& at) { return at.now.values[i]; }});
  return out;
}

std::map<std::string, double> Measures::numbers(const Measurement& of) const {
  std::map<std::string, double> out{{column::dissipated_energy, of.dissipated},
                                    {column::stored_energy, of.stored},
                                    {column::external_work, of.work},
                                    {column::load, of.load}};
  for (std::size_t i = 0; i < names_.size(); ++i)
    out.emplace(names_[i].name == "time" ? "gauge_time" : names_[i].name, of.values[i]);
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

}  // namespace dda
