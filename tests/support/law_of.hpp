#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "framework/deck/document/node.hpp"
#include "models/interface/law.hpp"

namespace dda {

/// The law that a deck names.
inline std::unique_ptr<InterfaceLaw> law_of(const std::string& text) {
  return interface_laws().choose(parse_yaml(text, "d")).make();
}

/// tan φ of an angle in degrees.
inline double tangent_of(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

}  // namespace dda
