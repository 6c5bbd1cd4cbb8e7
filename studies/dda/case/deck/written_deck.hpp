#pragma once

#include "studies/dda/case/deck/deck.hpp"
#include "studies/dda/case/deck/deck_tree.hpp"

namespace dda {

/// A deck as a file has it: with what is put in its place before anything is read on.
struct WrittenDeck : Deck {
  std::optional<std::string> extends;
  std::optional<std::map<std::string, double>> variables;
};

/// What a file may say: that of a deck, for explain and the JSON schema too.
const Schema<WrittenDeck>& written_deck_schema();

/// Reads and validates; expressions become numbers, and constants of a .geo file that are called like a variable get its
/// value. Throws InputError with every finding, among them variables that are used nowhere.
WrittenDeck values_of(const DeckTree& tree);

/// What the variables of a deck come to. Throws InputError for those that are wrong.
std::map<std::string, double> variables_of(const DeckTree& tree);

}  // namespace dda
