#include "framework/deck/writing/keys.hpp"

#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>

#include "framework/base/suggestion.hpp"
#include "framework/deck/family.hpp"
#include "framework/deck/writing/explain.hpp"

namespace dda {
namespace {

void add_keys(const SchemaBase& schema, const std::string& before, std::vector<DeckKey>& out) {
  for (const Parameter& parameter : schema.parameters()) {
    std::string path = before + parameter.name;
    out.push_back({path, parameter});
    const KindInfo* kind = &parameter.kind;
    while (kind->item) {
      path += kind->form == KindInfo::Form::map ? ".NAME" : ".0";
      kind = kind->item.get();
    }
    if (kind->section) add_keys(*kind->section, path + ".", out);
  }
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Every key of a deck, sections first and in their order, then those of the members of all families.
std::vector<DeckKey> all_keys(const SchemaBase& deck) {
  std::vector<DeckKey> keys = keys_of(deck);
  for (const FamilyBase* family : all_families())
    for (const FamilyMember* member : family->entries())
      add_keys(*member->schema, family->name() + "/" + member->name + ".", keys);
  return keys;
}

/// Words of the manual, for a suggestion.
std::vector<std::string> names_of(const std::vector<DeckKey>& keys) {
  std::vector<std::string> names;
  for (const DeckKey& key : keys) names.push_back(key.parameter.name);
  return names;
}

/// A place in decks: what may stand there, and what this deck has there.
struct Here {
  KindInfo kind;
  const Node* node = nullptr;
};

const Node* entry(const Node* node, const std::string& name) {
  if (!node) return nullptr;
  if (!node->is_sequence()) return node->find(name);
  const bool is_number = !name.empty() && name.size() < 9 &&
                         std::ranges::all_of(name, [](unsigned char c) { return std::isdigit(c); });
  return is_number && std::stoul(name) < node->items.size() ? &node->items[std::stoul(name)] : nullptr;
}

/// The parameters below a section or a choice: of a choice those of the member that the deck has, else of all.
std::vector<Parameter> parameters_of(const KindInfo& kind, const Node* node) {
  if (kind.section) return kind.section->parameters();
  if (!kind.family) return {};
  const Node* type = node && node->is_map() ? node->find("type") : node;
  if (const FamilyMember* member = type && type->is_scalar() ? kind.family->find(type->text) : nullptr)
    return member->schema->parameters();
  std::vector<Parameter> all;
  for (const FamilyMember* member : kind.family->entries())
    for (Parameter& parameter : member->schema->parameters())
      if (std::ranges::find(all, parameter.name, &Parameter::name) == all.end())
        all.push_back(std::move(parameter));
  return all;
}

KindInfo type_of(const FamilyBase& family) {
  KindInfo kind{.form = KindInfo::Form::name};
  for (const FamilyMember* member : family.entries()) kind.names.push_back(member->name);
  return kind;
}

std::vector<Proposal> values_of(const KindInfo& kind) {
  std::vector<Proposal> out;
  for (const std::string& name : kind.names) out.push_back({name, ""});
  if (kind.form == KindInfo::Form::boolean) out = {{"true", ""}, {"false", ""}};
  if (kind.family)
    for (const FamilyMember* member : kind.family->entries())
      out.push_back({member->name, member->schema->text()});
  return out;
}

/// The place below by one name of a path.
std::optional<Here> below(const Here& here, const std::string& name) {
  const Node* node = entry(here.node, name);
  const bool is_missing = here.kind.form == KindInfo::Form::list && here.node && !node;
  if (is_missing) return {};
  if (here.kind.item) return Here{*here.kind.item, node};
  if (here.kind.family && name == "type") return Here{type_of(*here.kind.family), node};
  const auto known = parameters_of(here.kind, here.node);
  const auto found = std::ranges::find(known, name, &Parameter::name);
  return found == known.end() ? std::nullopt : std::optional(Here{found->kind, node});
}

/// Whether something stands below a value of this kind.
bool has_keys(const KindInfo& kind) { return kind.section || kind.family || kind.item; }

/// What may stand in a place: keys with '.' or '=' behind them.
std::vector<Proposal> keys_in(const KindInfo& kind, const Node* node) {
  std::vector<Proposal> out;
  const auto add = [&](const std::string& name, const KindInfo& of, const std::string& text) {
    const bool is_choice = of.family != nullptr;  // its name alone is a value, too
    if (has_keys(of)) out.push_back({name + ".", text});
    if (!has_keys(of) || is_choice) out.push_back({name + "=", text});
  };
  if (kind.item && node && node->is_map())
    for (const NodeEntry& one : node->entries) add(one.key, *kind.item, "");
  if (kind.item && node && node->is_sequence())
    for (std::size_t i = 0; i < node->items.size(); ++i) add(std::to_string(i), *kind.item, "");
  if (kind.item) return out;
  if (kind.family) add("type", type_of(*kind.family), kind.family->text());
  for (const Parameter& parameter : parameters_of(kind, node))
    add(parameter.name, parameter.kind, parameter.text);
  return out;
}

std::vector<Proposal> beginning_with(std::vector<Proposal> list, const std::string& before,
                                     const std::string& part) {
  std::erase_if(list, [&](const Proposal& one) { return !one.text.starts_with(part); });
  for (Proposal& one : list) one.text = before + one.text;
  return list;
}

}  // namespace

std::vector<DeckKey> keys_of(const SchemaBase& schema, const std::string& before) {
  std::vector<DeckKey> keys;
  add_keys(schema, before, keys);
  return keys;
}

std::string find_in_manual(const SchemaBase& deck, const std::string& word, const Units& units) {
  const std::vector<DeckKey> keys = all_keys(deck);
  const std::string wanted = lower(word);
  const auto has = [&](const std::string& text) { return lower(text).find(wanted) != std::string::npos; };
  std::string out;
  for (const FamilyBase* family : all_families())
    for (const FamilyMember* member : family->entries())
      if (has(member->name) || has(member->schema->text()))
        out += "  " + family->name() + "/" + member->name + "\n      " + member->schema->text() + "\n";
  for (const auto& [path, parameter] : keys)
    if (has(path) || has(parameter.text))
      out += "  " + path + ": " + facts(parameter, units) + "\n      " + parameter.text + "\n";
  if (wanted.empty() || out.empty()) {
    const std::string near = did_you_mean(word, names_of(keys));
    throw InputError(Position{}, "no key of decks has '" + word + "' in its name or text" +
                                     (near.empty() ? "; `dda explain` lists all" : near));
  }
  return out;
}

std::vector<Proposal> proposed_settings(const SchemaBase& deck, const Node& root, const std::string& begun) {
  const std::size_t equals = begun.find('=');
  const std::string path = begun.substr(0, equals);
  const std::shared_ptr<const SchemaBase> not_owned(std::shared_ptr<void>(), &deck);
  std::optional<Here> here{{{.form = KindInfo::Form::section, .section = not_owned}, &root}};
  std::size_t from = 0;
  for (std::size_t dot = path.find('.'); here && dot != std::string::npos; dot = path.find('.', from)) {
    here = below(*here, path.substr(from, dot - from));
    from = dot + 1;
  }
  if (here && equals != std::string::npos) here = below(*here, path.substr(from));
  if (!here) return {};
  if (equals == std::string::npos)
    return beginning_with(keys_in(here->kind, here->node), path.substr(0, from), path.substr(from));
  return beginning_with(values_of(here->kind), path + "=", begun.substr(equals + 1));
}

std::vector<Proposal> proposed_topics(const SchemaBase& deck, const std::string& begun) {
  std::vector<Proposal> all;
  for (const Parameter& parameter : deck.parameters()) all.push_back({parameter.name, parameter.text});
  for (const FamilyBase* family : all_families()) {
    all.push_back({family->name(), family->text()});
    for (const FamilyMember* member : family->entries())
      if (begun.starts_with(family->name()))
        all.push_back({family->name() + "/" + member->name, member->schema->text()});
  }
  if (begun.find('.') != std::string::npos)
    for (const auto& [path, parameter] : keys_of(deck))
      if (path.find("NAME") == std::string::npos) all.push_back({path, parameter.text});
  return beginning_with(std::move(all), "", begun);
}

}  // namespace dda
