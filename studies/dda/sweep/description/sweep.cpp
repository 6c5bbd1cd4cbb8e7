#include "studies/dda/sweep/description/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "framework/deck/changes/settings.hpp"
#include "framework/deck/dimension_of.hpp"
#include "studies/dda/case/deck/written_deck.hpp"
#include "studies/dda/sweep/description/sweep_decks.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr const char* section = "sweep";
constexpr const char* deck_key = "deck";
constexpr const char* seed_key = "seed";
constexpr const char* columns_key = "columns";

bool concerns_section(const std::string& assignment) {
  const bool begins = assignment.starts_with("sweep.") || assignment.starts_with("sweep=");
  return begins && assignment.find('=') != std::string::npos;
}

/// `sweep.some.key=values` is the entry `some.key` of the section: there a dotted path is one name.
void set_in_section(Node& root, const std::string& text) {
  const std::string key = text.substr(0, text.find('=')), prefix = std::string(section) + ".";
  Node scratch = Node::map();
  set_value(scratch, text);
  Node value = *find_value(scratch, key);
  if (!key.starts_with(prefix)) return root.set(section, std::move(value));
  if (!root.find(section) || !root.find(section)->is_map()) root.set(section, Node::map());
  root.find(section)->set(key.substr(prefix.size()), std::move(value));
}

Node without(const Node& map, const std::string& key) {
  Node out = map;
  std::erase_if(out.entries, [&](const NodeEntry& entry) { return entry.key == key; });
  return out;
}

/// Makes the cases of a sweep; one wrong key is one finding, in however many cases it stands.
class SweepReader {
 public:
  SweepReader(DeckSource source, const std::vector<std::string>& overrides) : tree_(std::move(source.root)) {
    sweep_.file = std::move(source.path);
    sweep_.text = std::move(source.text);
    sweep_.overrides = overrides;
    for (const std::string& text : overrides)
      (concerns_section(text) ? section_overrides_ : deck_overrides_).push_back(text);
    for (const std::string& text : section_overrides_) set_in_section(tree_.root(), text);
  }

  Sweep read() {
    refuse_deck_beside();
    const Node* entries = tree_.root().find(section);
    if (!entries || entries->is_null())
      throw InputError(Position{sweep_.file.string()},
                       "has no section `sweep`; `dda explain sweep` says what stands in it");
    Node varied = *entries;
    if (const Node* deck = entries->find(deck_key); deck && deck->is_scalar()) {
      base_ = *deck;
      varied = without(varied, deck_key);
    }
    if (const Node* columns = entries->find(columns_key)) {
      sweep_.derived = read_derived_columns(*columns, findings_);
      varied = without(varied, columns_key);
    }
    sweep_.axes = read_axes(varied);
    keys_ = sweep_.keys();
    refuse_columns_of_keys();
    sweep_.key_units.resize(keys_.size());
    has_decks_ = !base_.is_null() || std::ranges::find(keys_, deck_key, &SweptKey::name) != keys_.end();
    refuse_second_deck();
    SweepDecks decks(sweep_.file, has_decks_ ? std::nullopt : std::optional(tree_), deck_overrides_);
    for (const auto& places : cases_of(sweep_.axes)) add_case(places, decks);
    findings_.throw_if_any();
    if (sweep_.title.empty()) sweep_.title = title_of(tree_.root());
    return std::move(sweep_);
  }

 private:
  /// The deck that a file of its own varies is an entry of its section.
  void refuse_deck_beside() const {
    for (const NodeEntry& entry : tree_.root().entries)
      if (entry.key == deck_key)
        throw InputError(
            entry.where,
            "'deck' stands in the section `sweep`, as `sweep: {deck: base.yaml, some.key: [1, 2]}`");
  }

  /// A file that names its decks may have a title beside the sweep, and nothing else.
  void refuse_second_deck() {
    if (!has_decks_) return;
    for (const NodeEntry& entry : tree_.root().entries)
      if (entry.key != section && entry.key != "title")
        findings_.add(entry.where,
                      fmt::format("'{}' belongs to a deck, and the sweep names decks of its own; "
                                  "remove one of them",
                                  entry.key));
    findings_.throw_if_any();
  }

  void refuse_columns_of_keys() {
    for (const DerivedColumn& column : sweep_.derived)
      if (std::ranges::find(keys_, column.name, &SweptKey::name) != keys_.end())
        findings_.add(column.where, fmt::format("columns.{0}: sweep.csv has a column of that name, of the "
                                                "varied key '{0}'; give another",
                                                column.name));
  }

  static std::string title_of(const Node& root) {
    const Node* title = root.find("title");
    return title ? title->text : "";
  }

  void add_case(const std::vector<std::size_t>& places, SweepDecks& decks) {
    SweepCase one;
    for (std::size_t a = 0; a < places.size(); ++a)
      for (const SweptKey& key : sweep_.axes[a].keys) one.values.push_back(key.values[places[a]]);
    try {
      fill(one, decks);
    } catch (const InputError& error) {
      for (const Finding& finding : error.findings())
        if (seen_.insert(to_string(finding.where) + finding.what).second)
          findings_.add(finding.where, finding.what);
    }
    sweep_.cases.push_back(std::move(one));
  }

  void fill(SweepCase& one, SweepDecks& decks) {
    Node name = base_;
    for (std::size_t k = 0; k < keys_.size(); ++k)
      if (keys_[k].name == deck_key) name = one.values[k];
    DeckTree tree = decks.tree(name);
    one.deck = decks.path(name);
    if (!has_decks_) one.overrides.push_back(assignment(section, Node{}));
    std::ranges::copy(deck_overrides_, std::back_inserter(one.overrides));
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      if (keys_[k].name == deck_key || keys_[k].name == seed_key) continue;
      one.overrides.push_back(assignment(keys_[k].name, one.values[k]));
      tree.set(keys_[k].name, one.values[k], keys_[k].where);
    }
    for (std::size_t k = 0; k < keys_.size(); ++k)
      if (keys_[k].name == seed_key) set_seeds(one, tree, k);
    conclude(one, tree);
  }

  void set_seeds(SweepCase& one, DeckTree& tree, std::size_t k) {
    one.seeds = paths_to(deck_schema().echo(values_of(tree)), seed_key);
    if (one.seeds.empty())
      throw InputError(keys_[k].where, fmt::format("seed: {} has no key of that name", one.deck.string()));
    for (const std::string& path : one.seeds) {
      one.overrides.push_back(assignment(path, one.values[k]));
      tree.set(path, one.values[k], keys_[k].where);
    }
  }

  void conclude(SweepCase& one, const DeckTree& tree) {
    const Deck deck = values_of(tree);
    const Node effective = deck_schema().echo(deck);
    one.effective = to_yaml(effective);
    CaseNumbers numbers{effective, {}, variables_of(tree)};
    for (std::size_t k = 0; k < keys_.size(); ++k) numbers.varied.emplace_back(keys_[k].name, one.values[k]);
    Findings findings;
    one.known = known_numbers(sweep_.derived, numbers, findings);
    findings.throw_if_any();
    if (!sweep_.cases.empty()) return;
    sweep_.units = deck.units;
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      const Dimension dimension = dimension_of(deck_schema(), effective, keys_[k].name);
      if (dimension != dimension::none) sweep_.key_units[k] = label(dimension, deck.units);
    }
  }

  Sweep sweep_;
  DeckTree tree_;
  Node base_;  ///< the deck of all cases, null when it is the file itself
  std::vector<SweptKey> keys_;
  std::vector<std::string> section_overrides_, deck_overrides_;
  bool has_decks_ = false;
  std::set<std::string> seen_;
  Findings findings_;
};

/// The shortest end of a dotted key that no other key shares.
std::string short_name(const std::string& name, const std::vector<SweptKey>& keys) {
  for (auto dot = name.rfind('.'); dot != std::string::npos && dot > 0; dot = name.rfind('.', dot - 1)) {
    const std::string end = name.substr(dot);
    const auto sharing =
        std::ranges::count_if(keys, [&](const SweptKey& key) { return ("." + key.name).ends_with(end); });
    if (sharing == 1) return end.substr(1);
  }
  return name;
}

}  // namespace

std::vector<SweptKey> Sweep::keys() const {
  std::vector<SweptKey> out;
  for (const Axis& axis : axes) std::ranges::copy(axis.keys, std::back_inserter(out));
  return out;
}

bool is_sweep(const Node& root, const std::vector<std::string>& overrides) {
  Node own = Node::map();
  if (const Node* given = root.find(section)) own.set(section, *given);
  for (const std::string& text : overrides)
    if (concerns_section(text)) set_in_section(own, text);
  const Node* found = own.find(section);
  return found && !found->is_null();
}

Sweep read_sweep(const fs::path& file, const std::vector<std::string>& overrides) {
  return SweepReader(read_source(file), overrides).read();
}

std::string setting_text(const Sweep& sweep, const SweepCase& one, std::size_t key) {
  const std::vector<SweptKey> keys = sweep.keys();
  return short_name(keys[key].name, keys) + "=" + to_flow_yaml(one.values[key]);
}

std::string settings_text(const Sweep& sweep, const SweepCase& one) {
  std::string out;
  for (std::size_t k = 0; k < one.values.size(); ++k)
    out += (k > 0 ? ", " : "") + setting_text(sweep, one, k);
  return out;
}

}  // namespace dda
