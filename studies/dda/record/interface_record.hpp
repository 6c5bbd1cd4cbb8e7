#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "studies/dda/record/fields.hpp"
#include "studies/dda/record/recorded_column.hpp"
#include "studies/dda/record/run_memory.hpp"

namespace dda {

/// What every named interface of the deck comes to along the path: the energy spent on it, and where it
/// cracks.
///
///     columns     dissipated_energy_<name> = Σ W G(h) over its points [FL]
///     summary     dissipated; the first crack (step, place); at the end the widest opening w_n, the largest
///                 sliding |w_s| and their places, and the share of its area that has spent energy
///
/// The columns add up to dissipated_energy. Where several points of an interface crack in one step, that
/// which spent most per area is its first.
class InterfaceRecord {
 public:
  /// `memory` remembers the first cracks.
  InterfaceRecord(const Equilibrium& equilibrium, const Units& units, RunMemory& memory);

  /// They tell what it has looked at last.
  RecordedColumns columns() const;
  /// Notes the energies and what has cracked for the first time.
  void look(const RecordedStep& at);
  /// By name, at the end of the run.
  nlohmann::ordered_json summary(const Fields& fields, const StoredState& end) const;

 private:
  void note_first_cracks(int step, const std::vector<History>& history);

  const Equilibrium& equilibrium_;
  std::string energy_unit_;
  std::vector<double> energies_;  ///< by interface [FL]
  RunMemory& memory_;
};

}  // namespace dda
