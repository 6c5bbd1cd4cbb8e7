#pragma once

#include <optional>
#include <string>

namespace dda {

/// What a step of the path has been taken by, the column `control` of curve.csv.
enum class StepKind {
  load,             ///< the load factor prescribed
  displacement,     ///< a displacement
  opening,          ///< a relative displacement
  dissipation,      ///< the energy that is dissipated
  arc_length,       ///< LOCA's arc length
  event,            ///< to the next initiation, or the next change of a contact
  initiation,       ///< to the next crack that starts while others grow
  corner,           ///< to where a growing crack passes a corner of its law
  unloading,        ///< off the damage surfaces
  release,          ///< strength that is lost at once
  load_increments,  ///< an increment of the load
  growth,           ///< a crack through blocks aims or grows
  jump,             ///< a rescue: to what a test finds that prescribes the displacement of the load
};

/// Its name in files and messages.
const std::string& to_string(StepKind kind);
/// The kind of that name; nothing for any other text.
std::optional<StepKind> step_kind(const std::string& name);

}  // namespace dda
