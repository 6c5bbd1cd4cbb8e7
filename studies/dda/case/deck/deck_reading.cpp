#include <fmt/format.h>

#include <algorithm>

#include "framework/deck/changes/settings.hpp"
#include "framework/deck/expression/reading_scope.hpp"
#include "framework/files/whole_file.hpp"
#include "meshing/files/geo_constants.hpp"
#include "studies/dda/case/deck/gauge_names.hpp"
#include "studies/dda/case/deck/lists/parameter_list.hpp"
#include "studies/dda/case/deck/written_deck.hpp"

namespace dda {
namespace {

void refuse_sweep(const Node& root) {
  const Node* sweep = root.find("sweep");
  if (sweep && !sweep->is_null())
    throw InputError(
        sweep->where,
        "sweep: this is a deck of many runs, for `dda sweep` or `dda run`; `--set sweep=` leaves "
        "the deck alone");
}

/// DeckTree has taken those of files; a setting comes too late.
void refuse_extends(const Node& root) {
  const Node* extends = root.find("extends");
  if (extends && !extends->is_null())
    throw InputError(extends->where, "extends: stands in the file of the deck and cannot be set");
}

/// Parameters of a .geo file that are called like a variable get its value.
void give_to_geometry(Variables& variables, Scene& scene) {
  if (!variables.has_any() || scene.type != SceneType::geo || !scene.file) return;
  for (const std::string& name : constants_of_geometry(*scene.file))
    if (variables.has(name) && !scene.parameters.contains(name))
      if (const auto value = variables.value(name)) scene.parameters[name] = *value;
}

Node section_of(const DeckTree& tree) {
  const Node* section = tree.root().find("variables");
  return section ? *section : Node();
}

/// In which the name of a file with NOX's and LOCA's parameters starts.
std::filesystem::path folder_of_list(const DeckTree& tree, const std::filesystem::path& deck) {
  const Node* list = find_value(tree.root(), "path.parameters");
  const bool is_of_base = list && tree.bases().contains(list->where.file);
  return (is_of_base ? std::filesystem::path(list->where.file) : deck).parent_path();
}

}  // namespace

DeckSource read_source(const std::filesystem::path& path) {
  std::string text = read_whole(path);
  Node root = parse_yaml(text, path.string());
  return {path, std::move(text), std::move(root)};
}

std::map<std::string, double> variables_of(const DeckTree& tree) {
  Findings findings;
  std::map<std::string, double> out = Variables(section_of(tree), findings).values();
  findings.throw_if_any();
  return out;
}

WrittenDeck values_of(const DeckTree& tree) {
  Findings findings;
  Variables variables(section_of(tree), findings);
  const ReadingScope scope(variables, tree.bases());
  WrittenDeck out = written_deck_schema().read(tree.root(), findings);
  give_to_geometry(variables, out.scene);
  if (findings.empty()) variables.refuse_unused(tree.replaced_names(), findings);
  findings.throw_if_any();
  return out;
}

namespace {

Deck values_of(const DeckTree& tree, const ListedKeys& listed) {
  try {
    return values_of(tree);
  } catch (const InputError& error) {
    throw said_by_lists(error, listed, tree.root());
  }
}

}  // namespace

DeckFile read_deck(DeckSource source, const std::vector<std::string>& overrides) {
  DeckTree tree(std::move(source.root));
  for (const std::string& assignment : overrides) tree.set(assignment);
  refuse_sweep(tree.root());
  refuse_extends(tree.root());
  ResolvedLists lists = resolve_parameter_lists(tree.root(), folder_of_list(tree, source.path));
  std::vector<std::string> resolved = overrides;
  resolved.insert(resolved.end(), lists.assignments.begin(), lists.assignments.end());
  DeckFile out{.path = std::move(source.path),
               .text = std::move(source.text),
               .overrides = std::move(resolved),
               .deck = values_of(tree, lists.keys)};
  Deck& deck = out.deck;
  check_gauge_names(deck, tree.root());
  deck.listed = std::move(lists.keys);
  if (deck.path.then == AfterPath::motion && !deck.motion) {
    deck.motion = motion_schema().read(Node::map());
    deck.motion->where = deck.path.where;
  }
  return out;
}

DeckFile read_deck(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read_deck(read_source(path), overrides);
}

DeckFile deck_from_text(const std::string& text, const std::filesystem::path& path,
                        const std::vector<std::string>& overrides) {
  return read_deck({path, text, parse_yaml(text, path.string())}, overrides);
}

}  // namespace dda
