#include "studies/dda/sweep/sweep_decks.hpp"

#include <fmt/format.h>

namespace dda {

namespace fs = std::filesystem;

SweepDecks::SweepDecks(fs::path file, Node own, std::vector<std::string> overrides)
    : file_(std::move(file)), overrides_(std::move(overrides)) {
  if (own.is_null()) return;
  set_all(own);
  roots_.emplace(file_, std::move(own));
}

fs::path SweepDecks::path(const Node& name) const {
  return name.is_null() ? file_ : (file_.parent_path() / name.text).lexically_normal();
}

const Node& SweepDecks::root(const Node& name) {
  const fs::path wanted = path(name);
  const auto known = roots_.find(wanted);
  return known != roots_.end() ? known->second : read(wanted, name);
}

const Node& SweepDecks::read(const fs::path& wanted, const Node& name) {
  if (!name.is_scalar()) throw InputError(name.where, "deck: expected the name of a file");
  if (!fs::exists(wanted))
    throw InputError(name.where, fmt::format("deck: no such file '{}' (looked for {})", name.text,
                                             fs::absolute(wanted).lexically_normal().string()));
  Node root = read_yaml(wanted);
  set_all(root);
  if (const Node* inner = root.find("sweep"); inner && !inner->is_null())
    throw InputError(name.where, fmt::format("deck: '{}' is a sweep itself", name.text));
  return roots_.emplace(wanted, std::move(root)).first->second;
}

void SweepDecks::set_all(Node& root) const {
  for (const std::string& text : overrides_) set_value(root, text);
}

}  // namespace dda
