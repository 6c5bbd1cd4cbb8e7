#include "framework/deck/changes/extended.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "framework/deck/expression/variables.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr const char* key = "extends";

Node taken(Node& map, const char* name) {
  const auto found = std::ranges::find(map.entries, name, &NodeEntry::key);
  if (found == map.entries.end()) return {};
  Node out = std::move(found->value);
  map.entries.erase(found);
  return out;
}

std::string type_of(const Node& map) {
  const Node* type = map.find("type");
  return type && type->is_scalar() ? type->text : "";
}

/// Members of a family have parameters of their own.
bool add_up(const Node& below, const Node& above) {
  const bool are_maps = below.is_map() && above.is_map();
  return are_maps && (type_of(above).empty() || type_of(above) == type_of(below));
}

class Extension {
 public:
  ExtendedNode of(Node deck) {
    out_.root = whole(std::move(deck));
    return std::move(out_);
  }

 private:
  Node whole(Node deck) {
    const Node name = taken(deck, key);
    if (name.is_null()) return deck;
    if (!name.is_scalar() || name.text.empty())
      throw InputError(name.where, "extends: expected the name of the deck that this one is built on");
    chain_.push_back(deck.where.file);
    const fs::path file = (fs::path(deck.where.file).parent_path() / name.text).lexically_normal();
    refuse_circle(file, name.where);
    std::error_code error;
    if (!fs::exists(file, error))
      throw InputError(name.where, fmt::format("extends: no such file '{}' (looked for {})", name.text,
                                               fs::absolute(file, error).lexically_normal().string()));
    Node base = whole(read_yaml(file));
    out_.bases.insert(file.string());
    put_over(base, std::move(deck));
    return base;
  }

  void refuse_circle(const fs::path& file, const Position& where) const {
    std::error_code error;
    for (const std::string& known : chain_)
      if (fs::equivalent(known, file, error))
        throw InputError(where, fmt::format("extends: '{}' is built on this deck itself", file.string()));
  }

  void put_over(Node& below, Node above) {
    if (!add_up(below, above)) {
      collect_names(below, out_.replaced);
      below = std::move(above);
      return;
    }
    below.where = above.where;
    for (NodeEntry& entry : above.entries) {
      const auto known = std::ranges::find(below.entries, entry.key, &NodeEntry::key);
      if (known == below.entries.end()) {
        below.entries.push_back(std::move(entry));
      } else if (entry.value.is_null()) {
        collect_names(known->value, out_.replaced);
        below.entries.erase(known);
      } else {
        known->where = entry.where;
        put_over(known->value, std::move(entry.value));
      }
    }
  }

  ExtendedNode out_;
  std::vector<std::string> chain_;
};

}  // namespace

ExtendedNode extended(Node deck) { return Extension().of(std::move(deck)); }

}  // namespace dda
