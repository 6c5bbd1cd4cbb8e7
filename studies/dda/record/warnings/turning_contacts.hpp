#pragma once

#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Where bodies turn on each other: sides that are open at one point and closed at another. With Gauss points a side turns
/// about one of these (TurningPlace), and what stands on it is overturned by less than it would be about the corner, down
/// to 1/√3 of the load with two points and √0.6 with three. So sides of separate bodies do, those that have lost their
/// strength in a mechanism, and cracked ones of mortar where what they bear, as much farther out, would change the
/// moment of all loads, about the size of the structure, by a hundredth: a beam that cracks along small sides does not.
///
/// "" where none does at the present state; else what it means and what to do.
std::string note_on_turning_contacts(const Simulation& simulation);

}  // namespace dda
