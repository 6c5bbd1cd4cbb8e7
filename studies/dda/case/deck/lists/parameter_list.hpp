#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/deck/document/node.hpp"
#include "studies/dda/case/deck/lists/listed_keys.hpp"

namespace dda {

/// Parameter lists of NOX and LOCA, as users of Trilinos write them, stand for keys of the deck: "Max Steps"
/// of LOCA's sublist "Stepper" for `path.stop.steps`. One table (parameter_list.cpp) tells which; what is not
/// in it is refused.

/// What lists have set: assignments ("path.stop.steps=40") that say the same, and the keys.
struct ResolvedLists {
  std::vector<std::string> assignments;
  ListedKeys keys;
};

/// Replaces `path.parameters` (a file, from the folder `base`), `path.nox` and `path.loca` of a deck's tree by
/// the keys that they stand for. Keys that the deck gives as well are refused where they differ, unless the list is
/// a file or comes by `--set`: then the list counts. Lists must not differ from each other.
/// Throws InputError with every parameter that is unknown, of another type, or has no effect here.
ResolvedLists resolve_parameter_lists(Node& root, const std::filesystem::path& base);

/// The list with every parameter as it is in a deck that has been read; XML.
std::string effective_parameter_list(const Node& deck);

/// The table as text, for `dda explain parameters`.
std::string explain_parameter_lists();

}  // namespace dda
