#pragma once

#include <string>
#include <vector>

#include "framework/files/curve_table.hpp"
#include "studies/dda/case/deck.hpp"

namespace dda::motion_column {

inline constexpr const char *work = "external_work", *kinetic = "kinetic_energy", *stored = "stored_energy",
                            *friction = "friction", *fracture = "fracture", *numerical = "impact_and_damping",
                            *error = "energy_error";

/// The columns of motion.csv that every motion has; gauges stand behind them.
std::vector<Column> all(const Units& units);

/// Throws InputError for a gauge that is called like one of them.
void require_free(const Deck& deck);

}  // namespace dda::motion_column
