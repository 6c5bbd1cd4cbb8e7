#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuation/handover/motion_parameters.hpp"
#include "models/body/body.hpp"

namespace dda {

/// Whether a region, by its index, is one of those named.
bool is_named(const std::vector<std::string>& regions, const Body& body, int region);

/// Whether the blocks of a region are held, or driven.
bool is_held(const Body& body, const MotionParameters& parameters, int region);

/// √area of the smallest block [L].
double smallest_size(const Assembly& assembly);

/// s, by which the deck has outlines shrunk [L].
double offset_of(const Body& body, const MotionParameters& parameters);

/// The first block that has no core at an offset, as text.
std::optional<std::string> too_narrow(const Assembly& assembly, double offset);

}  // namespace dda
