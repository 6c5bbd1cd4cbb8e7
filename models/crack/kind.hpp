#pragma once

#include "models/parameters.hpp"

namespace dda {

/// An entry of the deck's `cracks`.
Kind<CrackParameters> crack_kind();

}  // namespace dda
