#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuation/handover/motion_parameters.hpp"
#include "models/body/body.hpp"
#include "models/interface_point.hpp"

namespace dda {

/// Whether a region, by its index, is one of those named.
bool is_named(const std::vector<std::string>& regions, const Body& body, int region);

/// Whether the blocks of a region are held, or driven.
bool is_held(const Body& body, const MotionParameters& parameters, int region);

/// tan φ of bodies for which neither an interface nor a pair of materials has one: the deck's, else that of the
/// interfaces where all have the same, else none.
std::optional<double> friction_of_others(const InterfaceSet& interfaces, const MotionParameters& parameters);
/// Whether `pairs` have a coefficient of all materials whose blocks may meet.
bool pairs_tell_all(const Body& body, const MotionParameters& parameters);

/// Whether all blocks are one body for good, by joints that cannot tear, which is convex: no part of it can meet another.
bool is_one_convex_body(const Body& body, const InterfaceSet& interfaces);

/// √area of the smallest block [L].
double smallest_size(const Assembly& assembly);

/// s, by which the deck has outlines shrunk [L].
double offset_of(const Body& body, const MotionParameters& parameters);

/// The first block that has no core at an offset, as text.
std::optional<std::string> too_narrow(const Assembly& assembly, double offset);

}  // namespace dda
