#include "studies/dda/case/deck/deck_tree.hpp"

#include "framework/deck/changes/extended.hpp"
#include "framework/deck/changes/settings.hpp"
#include "framework/deck/expression/variables.hpp"

namespace dda {

DeckTree::DeckTree(Node deck) {
  ExtendedNode whole = extended(std::move(deck));
  root_ = std::move(whole.root);
  bases_ = std::move(whole.bases);
  replaced_ = std::move(whole.replaced);
  std::erase_if(root_.entries, [](const NodeEntry& entry) { return entry.key.starts_with(key_of_anchors); });
}

void DeckTree::replaces(const std::string& path) {
  if (const Node* old = find_value(root_, path)) collect_names(*old, replaced_);
}

void DeckTree::set(const std::string& assignment) {
  replaces(assignment.substr(0, assignment.find('=')));
  set_value(root_, assignment);
}

void DeckTree::set(const std::string& path, Node value, const Position& where) {
  replaces(path);
  set_value(root_, path, std::move(value), where);
}

}  // namespace dda
