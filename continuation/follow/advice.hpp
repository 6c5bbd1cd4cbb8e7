#pragma once

namespace dda {

/// What helps where steps fail or lead nowhere: the end of the message of a path that stops for want of one.
inline constexpr const char* what_to_try =
    "try a smaller `path.step.largest` (0.02), `points: vertices` or another `treatment` of the interfaces "
    "that crack, or another `path.control`";

}  // namespace dda
