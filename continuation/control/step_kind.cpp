#include "continuation/control/step_kind.hpp"

#include <algorithm>
#include <array>

namespace dda {
namespace {

/// In the order of the enumerators.
const std::array<std::string, 13>& names() {
  static const std::array<std::string, 13> names{
      "load",   "displacement", "opening", "dissipation",     "arc_length", "event", "initiation",
      "corner", "unloading",    "release", "load_increments", "growth",     "jump"};
  return names;
}

}  // namespace

const std::string& to_string(StepKind kind) { return names().at(static_cast<std::size_t>(kind)); }

std::optional<StepKind> step_kind(const std::string& name) {
  const auto found = std::ranges::find(names(), name);
  if (found == names().end()) return {};
  return static_cast<StepKind>(found - names().begin());
}

}  // namespace dda
