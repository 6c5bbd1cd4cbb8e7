#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "framework/deck/expression/variables.hpp"

namespace dda {

/// What the values of a deck are read with beside the deck itself: while a scope lives, expressions that this thread reads
/// speak of its variables, and relative file names of decks that the deck is built on start in the folders of those.
class ReadingScope {
 public:
  /// Both must outlive the scope. `bases` are files as positions name them.
  ReadingScope(Variables& variables, const std::set<std::string>& bases);
  ~ReadingScope();
  ReadingScope(const ReadingScope&) = delete;
  ReadingScope& operator=(const ReadingScope&) = delete;

  /// The variables of the innermost scope; none outside of all.
  static Variables& variables();
  /// Where the relative file name that a node says starts: the folder of its base, else `folder`.
  static std::filesystem::path folder_of(const Node& node, const std::filesystem::path& folder);

 private:
  Variables& variables_;
  const std::set<std::string>& bases_;
  const ReadingScope* outer_;
};

}  // namespace dda
