#pragma once

#include <memory>
#include <string>
#include <vector>

#include "framework/deck/family.hpp"

namespace dda {

/// How the displacement of a block varies within it, by region.
class Kinematics {
 public:
  virtual ~Kinematics() = default;
  /// Whether the strain of the region's blocks is linear in the place, not constant.
  virtual bool is_second_order(const std::string& region) const = 0;
  /// The regions it names.
  virtual std::vector<std::string> regions() const { return {}; }
};

using KinematicsFamily = Family<Kinematics>;
using KinematicsChoice = Choice<Kinematics>;

/// The registry of kinematics.
KinematicsFamily& kinematics();

}  // namespace dda
