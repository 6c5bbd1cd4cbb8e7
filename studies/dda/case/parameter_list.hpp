#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/deck/document/node.hpp"

namespace dda {

/// Parameter lists of NOX and LOCA, as users of Trilinos write them, stand for keys of the deck: "Max Steps"
/// of LOCA's sublist "Stepper" for `path.stop.steps`. One table (parameter_list.cpp) tells which; what is not
/// in it is refused.

/// Replaces `path.parameters` (a file, from the folder `base`), `path.nox` and `path.loca` of a deck's tree by
/// the keys that they stand for. Keys that the deck gives as well are refused where they differ, unless the list is
/// a file: then the file counts. Returns the assignments ("path.stop.steps=40") that say the same.
/// Throws InputError with every parameter that is unknown, of another type, or has no effect here.
std::vector<std::string> resolve_parameter_lists(Node& root, const std::filesystem::path& base);

/// The list with every parameter as it is in a deck that has been read; XML.
std::string effective_parameter_list(const Node& deck);

/// The table as text, for `dda explain parameters`.
std::string explain_parameter_lists();

}  // namespace dda
