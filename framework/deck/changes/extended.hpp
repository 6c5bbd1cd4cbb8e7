#pragma once

#include <set>

#include "framework/deck/document/node.hpp"

namespace dda {

/// A deck and those that it is built on, `extends: other.yaml`, as one tree.
struct ExtendedNode {
  Node root;
  std::set<std::string> bases;     ///< files that others extend, as positions name them
  std::set<std::string> replaced;  ///< names in expressions that a deck has replaced
};

/// Puts the deck over the one that it extends, relative to its own folder: keys of maps add up, everything else
/// replaces what the other says; so does a map whose `type` is another one. Positions stay those of either file.
/// Throws InputError at `extends` for a file that cannot be read and for decks that extend each other in a circle.
ExtendedNode extended(Node deck);

}  // namespace dda
