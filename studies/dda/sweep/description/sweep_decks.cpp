#include "studies/dda/sweep/description/sweep_decks.hpp"

#include <fmt/format.h>

namespace dda {

namespace fs = std::filesystem;

SweepDecks::SweepDecks(fs::path file, std::optional<DeckTree> own, std::vector<std::string> overrides)
    : file_(std::move(file)), overrides_(std::move(overrides)) {
  if (!own) return;
  DeckTree tree = with_all_set(std::move(*own));
  tree.set("sweep", Node(), tree.root().where);
  trees_.emplace(file_, std::move(tree));
}

fs::path SweepDecks::path(const Node& name) const {
  return name.is_null() ? file_ : (file_.parent_path() / name.text).lexically_normal();
}

const DeckTree& SweepDecks::tree(const Node& name) {
  const fs::path wanted = path(name);
  const auto known = trees_.find(wanted);
  return known != trees_.end() ? known->second : read(wanted, name);
}

const DeckTree& SweepDecks::read(const fs::path& wanted, const Node& name) {
  if (!name.is_scalar()) throw InputError(name.where, "deck: expected the name of a file");
  if (!fs::exists(wanted))
    throw InputError(name.where, fmt::format("deck: no such file '{}' (looked for {})", name.text,
                                             fs::absolute(wanted).lexically_normal().string()));
  DeckTree tree = with_all_set(DeckTree(read_yaml(wanted)));
  if (const Node* inner = tree.root().find("sweep"); inner && !inner->is_null())
    throw InputError(name.where, fmt::format("deck: '{}' is a sweep itself", name.text));
  return trees_.emplace(wanted, std::move(tree)).first->second;
}

DeckTree SweepDecks::with_all_set(DeckTree tree) const {
  for (const std::string& text : overrides_) tree.set(text);
  return tree;
}

}  // namespace dda
