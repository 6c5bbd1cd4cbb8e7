#include "studies/dda/run/recording/ended_path.hpp"

#include <string>

namespace dda {
namespace {

constexpr const char *numbers = "ended", *reason = "ended.reason";

/// All of a deck by which a path goes.
std::string path_of(Deck deck) {
  deck.title.clear();
  deck.record = {};
  deck.motion.reset();
  deck.path.then = {};
  return to_yaml(deck_schema().echo(deck));
}

}  // namespace

void put_ending(RestartData& data, const std::optional<Ending>& ending) {
  if (!ending) return;
  data.integers[numbers] = {static_cast<std::int64_t>(ending->kind)};
  if (ending->stop) data.integers[numbers].push_back(static_cast<std::int64_t>(*ending->stop));
  data.texts[reason] = {ending->reason};
}

std::optional<Ending> take_ending(const RestartData& data, const DeckFile& deck) {
  const auto found = data.integers.find(numbers);
  if (found == data.integers.end()) return {};
  const DeckFile before = deck_from_text(data.texts.at("deck.effective").at(0), deck.path, {});
  if (path_of(before.deck) != path_of(deck.deck)) return {};
  const auto kind = static_cast<Ending::Kind>(found->second.at(0));
  if (kind != Ending::Kind::goal_reached && kind != Ending::Kind::stopped_early) return {};
  Ending out{kind, data.texts.at(reason).at(0)};
  for (const auto& [stop, name] : names_of_stops)
    if (found->second.size() > 1 && found->second[1] == static_cast<std::int64_t>(stop)) out.stop = stop;
  return out;
}

}  // namespace dda
