#include "studies/dda/case/deck/gauge_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "framework/base/suggestion.hpp"
#include "framework/deck/changes/settings.hpp"

namespace dda {
namespace {

constexpr std::array names_of_load{"load", "load_factor"};

class GaugeReferences {
 public:
  GaugeReferences(const Deck& deck, const Node& root, Findings& findings) : root_(root), findings_(findings) {
    for (const auto& [name, choice] : deck.gauge_names) gauges_.push_back(name);
  }

  void check_own() {
    if (const Node* gauges = find_value(root_, "gauges"))
      for (const NodeEntry& gauge : gauges->entries)
        if (std::ranges::find(names_of_load, gauge.key) != names_of_load.end())
          findings_.add(gauge.where,
                        fmt::format("gauge '{0}': `until`, `stop.gauges` and the results mean the {1} by "
                                    "'{0}'; choose another name",
                                    gauge.key, gauge.key == "load" ? "load of the path" : "load factor"));
  }

  void check_text(const std::string& path) {
    const Node* text = find_value(root_, path);
    if (text && text->is_scalar() && !text->text.empty()) check(text->text, text->where, gauges_);
  }

  /// Keys of a map that may also mean the load.
  void check_keys(const std::string& path) {
    const Node* map = find_value(root_, path);
    if (!map) return;
    std::vector<std::string> known(names_of_load.begin(), names_of_load.end());
    known.insert(known.end(), gauges_.begin(), gauges_.end());
    for (const NodeEntry& entry : map->entries) check(entry.key, entry.where, known);
  }

 private:
  void check(const std::string& name, const Position& where, const std::vector<std::string>& known) {
    if (std::ranges::find(known, name) == known.end())
      findings_.add(where, "unknown gauge '" + name + "'" + suggest(name, known));
  }

  const Node& root_;
  Findings& findings_;
  std::vector<std::string> gauges_;
};

}  // namespace

void check_gauge_names(const Deck& deck, const Node& root) {
  Findings findings;
  GaugeReferences names(deck, root, findings);
  if (deck.has_path()) names.check_own();
  names.check_text("path.load_gauge");
  for (const char* map : {"path.stop.gauges", "record.at", "record.reference_peak.at"}) names.check_keys(map);
  for (std::size_t s = 0; s < deck.stages.size(); ++s) names.check_keys(fmt::format("stages.{}.until", s));
  findings.throw_if_any();
}

}  // namespace dda
