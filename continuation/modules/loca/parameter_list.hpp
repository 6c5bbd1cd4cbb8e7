#pragma once

#include <Teuchos_ParameterList.hpp>

#include "framework/deck/node.hpp"

namespace dda {

/// Copies a deck's map into a parameter list, verbatim: maps become sublists, scalars bool, int, double or
/// string.
void merge(const Node& from, Teuchos::ParameterList& into);

}  // namespace dda
