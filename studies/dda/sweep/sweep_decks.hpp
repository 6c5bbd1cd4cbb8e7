#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/deck/document/node.hpp"

namespace dda {

/// The decks that the cases of a sweep start from, each read once, with the overrides of the command line.
class SweepDecks {
 public:
  /// `own` is the deck that the sweep's file holds, null when the sweep names its decks.
  SweepDecks(std::filesystem::path file, Node own, std::vector<std::string> overrides);

  /// Of a deck as the sweep names it: from the folder of the sweep's file; null is the file itself.
  std::filesystem::path path(const Node& name) const;
  /// Throws InputError at the name when there is no such deck.
  const Node& root(const Node& name);

 private:
  const Node& read(const std::filesystem::path& wanted, const Node& name);
  void set_all(Node& root) const;

  std::filesystem::path file_;
  std::vector<std::string> overrides_;
  std::map<std::filesystem::path, Node> roots_;
};

}  // namespace dda
