#pragma once

#include <string>
#include <vector>

#include "framework/files/curve_table.hpp"
#include "studies/dda/case/deck/deck.hpp"

namespace dda::motion_column {

inline constexpr const char *work = "external_work", *kinetic = "kinetic_energy", *stored = "stored_energy",
                            *strain = "strain_energy", *contact = "contact_energy",
                            *impacts = "impact_energy",  // parts of what is stored
                                *friction = "friction", *fracture = "fracture", *damping = "viscous_damping",
                            *impact = "impact", *numerical = "numerical_damping", *error = "energy_error";

/// The columns of motion.csv but for the gauges, which stand behind them: those of the energy book, and what fracture has
/// taken on every interface.
std::vector<Column> all(const Units& units, const std::vector<std::string>& interfaces);

/// Throws InputError for a gauge that is called like one of them.
void require_free(const Deck& deck, const std::vector<std::string>& interfaces);

}  // namespace dda::motion_column
