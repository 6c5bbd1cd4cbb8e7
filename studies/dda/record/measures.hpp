#pragma once

#include <map>
#include <string>
#include <vector>

#include "continuation/path/path.hpp"
#include "framework/deck/units.hpp"
#include "studies/dda/record/recorded_column.hpp"

namespace dda {

/// One accepted state in the numbers of `curve.csv`.
struct Measurement {
  int step = 0;
  double load_factor = 0;
  std::string control;
  int newton_iterations = 0;
  double dissipated = 0, stored = 0, work = 0;  ///< since the start of the run [FL]
  double load = 0;
  std::vector<double> values;  ///< gauges and reactions, see Measures

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("step", self.step);
    visit("load_factor", self.load_factor);
    visit("control", self.control);
    visit("newton_iterations", self.newton_iterations);
    visit("dissipated", self.dissipated);
    visit("stored", self.stored);
    visit("work", self.work);
    visit("load", self.load);
    visit("values", self.values);
  }
};

/// What is recorded of every accepted state: the path's own numbers, every gauge and every reaction.
class Measures {
 public:
  /// A gauge whose name one of the columns takes, of these or of `others`, or is `stage`, is called gauge_<name>, a reaction
  /// reaction_<name>.
  Measures(const Loading& loading, Functional load, std::string load_unit, const Units& units,
           const RecordedColumns& others);

  RecordedColumns columns() const;
  Measurement measure(const Walker& walker, int step, const std::string& control,
                      int newton_iterations) const;

  /// By name, but for step and load factor: what stored fields have beside them. A gauge `time`, which they have too, is
  /// gauge_time.
  std::map<std::string, double> numbers(const Measurement& of) const;

  /// Names and units in the order of Measurement::values; gauges stand first.
  const std::vector<Column>& names() const { return names_; }
  std::size_t num_gauges() const { return num_gauges_; }
  const std::vector<Functional>& functionals() const { return functionals_; }
  const std::string& load_unit() const { return load_unit_; }
  const std::string& energy_unit() const { return energy_unit_; }
  const Functional& load() const { return load_; }
  /// Indices of the gauges that are displacements.
  const std::vector<std::size_t>& displacements() const { return displacements_; }

 private:
  /// Those that every run has.
  RecordedColumns path_columns() const;

  Functional load_;
  std::string load_unit_, energy_unit_;
  std::vector<Column> names_;
  std::vector<Functional> functionals_;
  std::vector<std::size_t> displacements_;
  std::size_t num_gauges_ = 0;
};

/// The unit of a column: "" where `label` says "-".
std::string unit_of(Dimension dimension, const Units& units);

}  // namespace dda
