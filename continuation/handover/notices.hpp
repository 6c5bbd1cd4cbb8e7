#pragma once

#include <string>
#include <vector>

#include "continuation/handover/motion_parameters.hpp"
#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// What is worth knowing of a motion before it begins: contacts that the integrator lets ring, regions that are bonded without
/// an interface, friction that counts before that of pairs, a weight that acts twice.
std::vector<std::string> motion_notices(const Body& body, const Equilibrium& equilibrium,
                                        const MotionParameters& parameters);

}  // namespace dda
