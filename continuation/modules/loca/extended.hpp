#pragma once

#include <LOCA_MultiContinuation_ExtendedVector.H>

#include <algorithm>

#include "continuation/modules/loca/local_vector.hpp"

namespace dda {

/// The unknowns of a step as LOCA nests them: ((x, λ), s).
struct Extended {
  NOX::Abstract::Vector& x;
  double& load_factor;
  double& s;
};

inline Extended parts_of(NOX::Abstract::Vector& vector) {
  using Vector = LOCA::MultiContinuation::ExtendedVector;
  auto& outer = dynamic_cast<Vector&>(vector);
  auto& inner = dynamic_cast<Vector&>(*outer.getXVec());
  return {*inner.getXVec(), inner.getScalar(0), outer.getScalar(0)};
}

}  // namespace dda
