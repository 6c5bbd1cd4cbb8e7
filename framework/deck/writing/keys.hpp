#pragma once

#include <string>
#include <vector>

#include "framework/deck/schema.hpp"

namespace dda {

/// A key of decks, with its place: "path.stop.load_below", "interfaces.NAME.law", "law/linear_softening.cohesion".
struct DeckKey {
  std::string path;
  Parameter parameter;
};

/// Every key of a section, a whole deck or a member of a family, and of the sections below; `before` stands before its path.
std::vector<DeckKey> keys_of(const SchemaBase& schema, const std::string& before = "");

/// Keys whose path or text has this word, whatever its case, as `dda explain` shows them; InputError when there is none.
std::string find_in_manual(const SchemaBase& deck, const std::string& word, const Units& units = {"L", "F"});

/// Something that may stand where a key begins, and what it means.
struct Proposal {
  std::string text;
  std::string meaning;
};

/// How "path.to.key=value" may go on, as for --set: keys below a path (ending in '.' where more follows, in '=' where a value
/// does), entries and names that this deck has, or values of a key. An unfinished last part chooses among them.
std::vector<Proposal> proposed_settings(const SchemaBase& deck, const Node& root, const std::string& begun);

/// How a topic of `dda explain` may go on: sections, families, "law/linear_softening", "path.stop".
std::vector<Proposal> proposed_topics(const SchemaBase& deck, const std::string& begun);

}  // namespace dda
