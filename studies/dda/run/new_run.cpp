#include "studies/dda/run/new_run.hpp"

#include "framework/files/whole_file.hpp"
#include "studies/dda/case/deck/lists/parameter_list.hpp"

namespace dda {

namespace fs = std::filesystem;

RunFolder new_folder(const DeckFile& deck, const RunOptions& options) {
  fs::path wanted = options.folder;
  if (wanted.empty()) wanted = deck.deck.record.folder;
  const bool is_named = !wanted.empty();
  if (!is_named) wanted = default_run_folder(deck.path);
  if (options.overwrite) return RunFolder::create(wanted, IfExists::overwrite);
  if (!is_named) return RunFolder::create(wanted, IfExists::number);
  std::error_code error;
  if (fs::is_directory(wanted, error) && !fs::is_empty(wanted, error))
    throw InputError(Position{wanted.string()},
                     "the run folder exists and is not empty; choose another one or give "
                     "--overwrite");
  return RunFolder::create(wanted, IfExists::refuse);
}

void write_decks(const RunFolder& folder, const DeckFile& deck, const std::string& effective) {
  write_whole(folder.file("parameters.xml"), effective_parameter_list(deck_schema().echo(deck.deck)),
              Flush::to_system);
  write_whole(folder.file("deck.yaml"), deck.text, Flush::to_system);
  write_whole(folder.file("effective_deck.yaml"), effective, Flush::to_system);
}

}  // namespace dda
