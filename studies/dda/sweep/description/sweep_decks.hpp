#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/dda/case/deck/deck_tree.hpp"

namespace dda {

/// The decks that the cases of a sweep start from, each read once, with the overrides of the command line.
class SweepDecks {
 public:
  /// `own` is the deck that the sweep's file holds beside its section, none when the sweep names its decks.
  SweepDecks(std::filesystem::path file, std::optional<DeckTree> own, std::vector<std::string> overrides);

  /// Of a deck as the sweep names it: from the folder of the sweep's file; null is the file itself.
  std::filesystem::path path(const Node& name) const;
  /// Throws InputError at the name when there is no such deck.
  const DeckTree& tree(const Node& name);

 private:
  const DeckTree& read(const std::filesystem::path& wanted, const Node& name);
  DeckTree with_all_set(DeckTree tree) const;

  std::filesystem::path file_;
  std::vector<std::string> overrides_;
  std::map<std::filesystem::path, DeckTree> trees_;
};

}  // namespace dda
