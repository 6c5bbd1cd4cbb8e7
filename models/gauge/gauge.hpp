#pragma once

#include <map>
#include <memory>
#include <span>

#include "framework/deck/family.hpp"
#include "models/body/body.hpp"
#include "models/body/functional.hpp"

namespace dda {

/// What a gauge may read: places of the body, reactions by name, and the stress that is there without strain.
struct GaugeSources {
  const Body& body;
  const std::map<std::string, Reaction>& reactions;
  std::span<const Vec3> dead_stress = {}, reference_stress = {};  ///< σ0(λ) by block [F/L²]; empty when none
  std::span<const double> dead_out_of_plane = {}, reference_out_of_plane = {};  ///< likewise, see StageLoads
};

/// A scalar of the state recorded at every step, linear in (d, λ).
class Gauge {
 public:
  virtual ~Gauge() = default;
  /// The scalar. Throws InputError when its place is not on the structure.
  virtual Functional functional(const GaugeSources& sources) const = 0;
  /// What it measures: [L] for displacements, [F] for reactions.
  virtual Dimension dimension() const = 0;
  /// The same where it hangs on what is read.
  virtual Dimension dimension_of(const GaugeSources&) const { return dimension(); }
};

using GaugeFamily = Family<Gauge>;
using GaugeChoice = Choice<Gauge>;

/// The registry of gauges.
GaugeFamily& gauges();

}  // namespace dda
