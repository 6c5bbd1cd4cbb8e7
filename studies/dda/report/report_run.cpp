#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "framework/base/errors.hpp"
#include "framework/deck/document/node.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/record/column_names.hpp"
#include "studies/dda/record/stability_record.hpp"
#include "studies/dda/report/report.hpp"

namespace dda::report {
namespace fs = std::filesystem;
namespace {

/// Runs `read`; what it cannot read becomes a notice, and the page does without.
template <class Read>
void attempt(Json& data, const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    data["notices"].push_back(error.what());
  } catch (const Json::exception& error) {  // a text where a number should be
    data["notices"].push_back(error.what());
  }
}

/// The overrides stand as comments at the top of the effective deck.
Json overrides_in(const std::string& effective_deck) {
  constexpr std::string_view mark = "# --set ";
  Json out = Json::array();
  for (std::size_t begin = 0; begin < effective_deck.size() && effective_deck[begin] == '#';) {
    const std::size_t end = std::min(effective_deck.find('\n', begin), effective_deck.size());
    const std::string line = effective_deck.substr(begin, end - begin);
    if (line.starts_with(mark)) out.push_back(line.substr(mark.size()));
    begin = end + 1;
  }
  return out;
}

/// Rows of the peak, of the events and around the ends of stages, which no thinning may drop.
std::vector<std::size_t> marked_rows(const CsvTable& curve, const Json& summary,
                                     std::span<const int> stored) {
  std::vector<double> steps(stored.begin(), stored.end());
  if (summary.contains("peak")) steps.push_back(summary["peak"].value("step", 0));
  for (const Json& event : summary.value("events", Json::array()))
    if (event.is_object() && event.contains("step") && event["step"].is_number())
      steps.push_back(event["step"]);
  std::vector<std::size_t> out;
  const std::vector<double> numbers = curve.numbers(column::step);
  for (const double step : steps)
    out.push_back(static_cast<std::size_t>(std::ranges::lower_bound(numbers, step) - numbers.begin()));
  if (!curve.has(column::stage)) return out;
  const std::vector<double> stages = curve.numbers(column::stage);
  for (std::size_t row = 1; row < stages.size(); ++row)
    if (stages[row - 1] != stages[row]) out.insert(out.end(), {row - 1, row});
  return out;
}

Json data_of_curve(const fs::path& folder, Json& data, std::span<const int> stored, const Limits& limits) {
  const CsvTable curve = read_csv(folder / "curve.csv");
  const Json units = read_json(folder / "curve.units.json", data["notices"]);
  const Json summary = data["summary"].is_object() ? data["summary"] : Json::object();
  const std::size_t most = std::max<std::size_t>(2, limits.cells / curve.names().size());
  const std::vector<std::size_t> rows =
      kept_rows(curve.num_rows(), most, marked_rows(curve, summary, stored));
  Json out = columns_of(curve, units, rows);
  attempt(data, [&] { out["stability"] = between(chosen(stability_of(curve), rows)); });
  return out;
}

/// Step of the highest load, for a run that has no summary.
int peak_step(const CsvTable& curve) {
  const std::vector<double> load = curve.numbers(column::load), step = curve.numbers(column::step);
  const auto highest = std::ranges::max_element(load, {}, [](double value) { return std::abs(value); });
  return highest == load.end() ? -1
                               : static_cast<int>(step[static_cast<std::size_t>(highest - load.begin())]);
}

void add_decks(const fs::path& folder, Json& data, const Limits& limits) {
  if (fs::exists(folder / "model.svg") && fs::file_size(folder / "model.svg") <= limits.picture)
    data["model"] = read_whole(folder / "model.svg");
  data["deck"] = read_text(folder / "deck.yaml", limits.text);
  data["effective_deck"] = read_text(folder / "effective_deck.yaml", limits.text);
  data["overrides"] = overrides_in(data["effective_deck"]);
}

void add_title(const fs::path& folder, Json& data) {
  const Json& summary = data["summary"];
  std::string title;
  attempt(data, [&] {
    if (summary.is_object()) title = summary.value("title", "");
    const fs::path deck = folder / "effective_deck.yaml";
    if (!title.empty() || !fs::exists(deck)) return;
    const Node tree = read_yaml(deck);
    const Node* found = tree.find("title");
    if (found != nullptr) title = found->text;
  });
  data["title"] = title.empty() ? data["name"].get<std::string>() : title;
}

}  // namespace

bool is_run(const fs::path& folder) {
  return fs::exists(folder / "curve.csv") || fs::exists(folder / "log.jsonl") ||
         fs::exists(folder / "effective_deck.yaml");
}

Json read_json(const fs::path& file, Json& notices) {
  if (!fs::exists(file)) return nullptr;
  Json out = Json::parse(read_whole(file), nullptr, false);
  if (!out.is_discarded()) return out;
  notices.push_back(fmt::format("{}: is no JSON", file.string()));
  return nullptr;
}

std::string read_text(const fs::path& file, std::size_t most) {
  if (!fs::exists(file)) return {};
  std::string text = read_whole(file);
  if (text.size() <= most) return text;
  // Cut at a line, so that no character is cut in two.
  const std::size_t kept = text.rfind('\n', most);
  return text.substr(0, kept) +
         fmt::format("\n# ... and {} more characters, left out here\n", text.size() - kept);
}

namespace {

/// What has moved, with the keys of a path.
Json data_of_motion(const fs::path& folder, Json& data, const Limits& limits) {
  Json out = Json::object();
  attempt(data, [&] {
    const CsvTable curve = read_csv(folder / "motion.csv");
    const Json units = read_json(folder / "motion.units.json", data["notices"]);
    const std::size_t most = std::max<std::size_t>(2, limits.cells / curve.names().size());
    out["curve"] = columns_of(curve, units, kept_rows(curve.num_rows(), most, {}));
  });
  attempt(data, [&] {
    const ResultsReader results(folder);
    out["blocks"] = data_of_blocks(results, results.steps().back(), limits);
  });
  return out;
}

/// What the path has left behind.
void add_path(const fs::path& folder, Json& data, const Limits& limits) {
  std::optional<ResultsReader> results;
  attempt(data, [&] { results.emplace(folder); });
  attempt(data, [&] {
    data["curve"] = data_of_curve(folder, data, results ? results->steps() : std::vector<int>{}, limits);
  });
  attempt(data, [&] { data["log"] = data_of_log(folder / "log.jsonl", limits); });
  if (!results) return;
  attempt(data, [&] {
    data["blocks"] = data_of_blocks(*results, peak_step(read_csv(folder / "curve.csv")), limits);
  });
  attempt(data, [&] {
    data["provenance"] = results->provenance();
    for (const char* deck : {"deck", "effective_deck"}) data["provenance"].erase(deck);
  });
}

}  // namespace

Json data_of_run(const fs::path& folder, const Limits& limits) {
  const fs::path whole = (fs::absolute(folder) / "").lexically_normal();
  Json data{{"kind", "run"},
            {"name", whole.parent_path().filename().string()},
            {"generator", to_texts(provenance())},
            {"notices", Json::array()}};
  Json notices = Json::array();
  data["summary"] = read_json(folder / "summary.json", notices);
  data["notices"] = notices;
  add_decks(folder, data, limits);
  add_title(folder, data);
  const bool has_moved = fs::is_directory(folder / "motion");
  if (!has_moved || fs::exists(folder / "curve.csv")) add_path(folder, data, limits);
  if (has_moved) data["motion"] = data_of_motion(folder / "motion", data, limits);
  return data;
}

}  // namespace dda::report
