#include "continuation/modules/loca/equations_merit.hpp"

#include <LOCA_MultiContinuation_ExtendedGroup.H>

#include "continuation/modules/loca/group.hpp"

namespace dda {

double EquationsMerit::computef(const NOX::Abstract::Group& group) const {
  const auto& extended = dynamic_cast<const LOCA::MultiContinuation::ExtendedGroup&>(group);
  const Group& base = dynamic_cast<const Group&>(*extended.getBaseLevelUnderlyingGroup());
  const double norm = active_->equations->norm(base.iterate());
  return 0.5 * norm * norm;
}

double EquationsMerit::computeSlope(const NOX::Abstract::Vector&, const NOX::Abstract::Group& group) const {
  return -2 * computef(group);
}

}  // namespace dda
