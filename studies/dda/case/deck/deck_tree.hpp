#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "framework/deck/document/node.hpp"

namespace dda {

/// Keys of a deck that begin so are nobody's: they hold what anchors of YAML name, to be used elsewhere in the deck.
inline constexpr const char* key_of_anchors = "x-";

/// A deck before its values are read: put over those that it extends, without the keys that hold anchors, and set from the
/// command line.
///
/// Names in expressions that a setting or a deck above replaces stay known: a variable that only they have used is not one
/// that nobody needs.
class DeckTree {
 public:
  /// Throws InputError for what `extends` names and cannot be read.
  explicit DeckTree(Node deck);

  const Node& root() const { return root_; }
  /// For what does not replace values.
  Node& root() { return root_; }
  const std::set<std::string>& replaced_names() const { return replaced_; }
  /// Files that the deck is built on, as positions name them.
  const std::set<std::string>& bases() const { return bases_; }

  /// `--set path.to.key=value`, and the same with the value as a node; see framework/deck/changes/settings.hpp.
  void set(const std::string& assignment);
  void set(const std::string& path, Node value, const Position& where);

 private:
  void replaces(const std::string& path);

  Node root_;
  std::set<std::string> bases_, replaced_;
};

}  // namespace dda
