#pragma once

#include <cstddef>

namespace dda {

/// How much of a loop over a structure one thread takes at once.
inline constexpr std::size_t points_at_once = 2000, blocks_at_once = 8000, numbers_at_once = 50'000;

}  // namespace dda
