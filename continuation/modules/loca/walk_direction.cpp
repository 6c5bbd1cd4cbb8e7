#include "continuation/modules/loca/walk_direction.hpp"

#include <LOCA_MultiContinuation_ExtendedGroup.H>

#include "continuation/modules/loca/extended.hpp"
#include "continuation/modules/loca/group.hpp"

namespace dda {

bool WalkDirection::compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
                            const NOX::Solver::Generic&) {
  const auto& extended = dynamic_cast<const LOCA::MultiContinuation::ExtendedGroup&>(group);
  const Group& base = dynamic_cast<const Group&>(*extended.getBaseLevelUnderlyingGroup());
  auto& equations = dynamic_cast<WalkedEquations&>(*active_->equations);
  const std::vector<double> end = equations.walk_from(base.iterate());
  if (end.empty()) return false;
  direction = extended.getX();
  const Extended parts = parts_of(direction);
  const std::span<double> x = local(parts.x);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = end[i] - x[i];
  parts.load_factor = end.back() - parts.load_factor;
  parts.s = 0;
  return true;
}

}  // namespace dda
