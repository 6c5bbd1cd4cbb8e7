#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// The stiffness of a small assembly by contribution, K = K⁰ + Kᶜ + Kˢ + Kʷ: the `algorithmic` one with the
/// joint stiffness of the iteration, and the `physical` one of the eigenvalues (System::physical_stiffness),
/// at a state of the path.
struct StiffnessRecord {
  nlohmann::ordered_json numbers;  ///< {algorithmic, physical} × {strain, contact, support, weak}: rows
  std::string text;                ///< the 6 × 6 blocks that are not zero, by contribution
};

/// At the state at which the walker stands.
StiffnessRecord stiffness_record(const Simulation& simulation);

}  // namespace dda
