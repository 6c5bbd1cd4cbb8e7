#pragma once

#include <NOX_Abstract_Vector.H>

#include <span>

namespace dda {

/// A vector of NOX whose entries can be reached: those that this rank owns.
class LocalVector : public NOX::Abstract::Vector {
 public:
  virtual std::span<double> local() = 0;
  virtual std::span<const double> local() const = 0;
};

/// The entries of a vector that is one.
inline std::span<double> local(NOX::Abstract::Vector& x) { return dynamic_cast<LocalVector&>(x).local(); }
inline std::span<const double> local(const NOX::Abstract::Vector& x) {
  return dynamic_cast<const LocalVector&>(x).local();
}

}  // namespace dda
