#include "studies/dda/run/recording/same_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "framework/deck/document/node.hpp"

namespace dda {
namespace {

/// Keys of a deck that a run may go on with others of.
constexpr std::array<std::string_view, 4> free_keys{"title", "path", "motion", "record"};

bool is_free(const std::string& key) { return std::ranges::find(free_keys, key) != free_keys.end(); }

std::string joined(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

/// The first key in which two nodes differ; "" where they are the same.
std::string difference(const Node& one, const Node& other, const std::string& path) {
  if (one == other) return {};
  if (one.is_map() && other.is_map()) {
    for (const auto& [key, where, value] : one.entries) {
      const Node* its = other.find(key);
      if (!its) return joined(path, key);
      if (const std::string found = difference(value, *its, joined(path, key)); !found.empty()) return found;
    }
    for (const auto& [key, where, value] : other.entries)
      if (!one.find(key)) return joined(path, key);
  }
  if (one.is_sequence() && other.is_sequence())
    for (std::size_t i = 0; i < std::min(one.items.size(), other.items.size()); ++i)
      if (const std::string found = difference(one.items[i], other.items[i], fmt::format("{}.{}", path, i));
          !found.empty())
        return found;
  return path;
}

/// What may not be another: stages without their goals, as many as both decks have, and of the path the gauge that is called
/// its load.
Node fixed_part(const Deck& deck, std::size_t num_stages) {
  Node out = Node::map();
  for (const auto& [key, where, value] : deck_schema().echo(deck).entries)
    if (!is_free(key)) out.set(key, value);
  if (Node* stages = out.find("stages")) {
    stages->items.resize(std::min(stages->items.size(), num_stages));
    for (Node& stage : stages->items) stage.set("until", Node::map());
  }
  Node path = Node::map();
  path.set("load_gauge", Node::scalar(deck.path.load_gauge));
  out.set("path", path);
  return out;
}

}  // namespace

std::vector<std::string> remembered(const Equilibrium& equilibrium) {
  std::set<std::string> out;
  for (const auto& law : equilibrium.interfaces().laws) {
    std::string names;
    for (const Remembered& one : law->memory()) names += one.name + " ";
    out.insert(names);
  }
  return {out.begin(), out.end()};
}

void require_same_points(const RestartData& data, const std::filesystem::path& folder,
                         const Equilibrium& equilibrium) {
  if (data.texts.at("memory_of_laws") != remembered(equilibrium))
    throw InputError(Position{folder.string()},
                     "the interfaces have laws that remember other things than those of the run did; only "
                     "controls, stopping rules and records may change");
  const std::size_t width = data.texts.at("here.history.members").size();
  if (data.integers.at("unknowns").at(0) == std::int64_t(equilibrium.num_unknowns()) &&
      data.numbers.at("here.history").size() == width * equilibrium.num_active())
    return;
  throw InputError(
      Position{folder.string()},
      "the structure has another number of blocks or interface points than the run had; only controls, "
      "stopping rules and records may change");
}

void require_same_structure(const std::string& before, const Deck& now, const std::filesystem::path& folder) {
  const Deck then = deck_from_text(before, folder / "effective_deck.yaml", {}).deck;
  const std::size_t num_stages = std::min(then.stages.size(), now.stages.size());
  const std::string key = difference(fixed_part(then, num_stages), fixed_part(now, num_stages), "");
  if (key.empty()) return;
  throw InputError(
      Position{folder.string()},
      fmt::format("`{}` is another than the run had: only controls, goals and records may change; "
                  "`dda run` begins a run with it",
                  key));
}

}  // namespace dda
