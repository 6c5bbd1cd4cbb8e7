#pragma once

#include <fmt/format.h>

#include <string>

#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// Why a path ends whose points have no consistent rates.
inline constexpr const char* without_rates =
    "the path ends here: no rates were found that keep the equilibrium, whichever points crack, unload, "
    "slide and hold; the structure would go on dynamically";

/// What helps where steps fail or lead nowhere: the end of the message of a path that stops for want of one.
inline std::string what_to_try(const Equilibrium& equilibrium) {
  const char* points =
      equilibrium.num_gradients() == 0
          ? "`points: vertices`"
          : "blocks of first order with `points: vertices`";  // which those of second order refuse
  return fmt::format(
      "try a smaller `path.step.largest` (0.02), {} or another `treatment` of the interfaces that crack, or "
      "another `path.control`",
      points);
}

}  // namespace dda
