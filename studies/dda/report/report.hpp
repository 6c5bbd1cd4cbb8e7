#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "framework/files/curve_table.hpp"
#include "framework/files/run/results_reader.hpp"

namespace dda::report {

using Json = nlohmann::ordered_json;

/// What a page may hold, so that it stays below 20 MB and a browser stays quick.
struct Limits {
  std::size_t fields = 15'000'000;  ///< characters of geometry and stored steps
  std::size_t cells = 250'000;      ///< of the curve (11 characters each); of all curves of a sweep (5 each)
  std::size_t events = 400;         ///< of the log
  std::size_t text = 400'000;       ///< characters of each deck
  std::size_t picture = 4'000'000;  ///< of the model's picture
};

/// Whether a folder looks like what `dda run` (finished or not) or `dda sweep` writes.
bool is_run(const std::filesystem::path& folder);
bool is_sweep(const std::filesystem::path& folder);
/// The run folders of a sweep's cases, as far as they have begun.
std::vector<std::filesystem::path> runs_of_sweep(const std::filesystem::path& folder);

/// All that the page of a run shows. What is missing or unreadable (a run that was killed, say) is named in
/// the member `notices` and left out.
Json data_of_run(const std::filesystem::path& folder, const Limits& limits);
/// The same for a sweep; its links start at the folder of the page.
Json data_of_sweep(const std::filesystem::path& folder, const std::filesystem::path& page,
                   const Limits& limits);

/// The self-contained HTML page; its scripts find what figures share in STYLE.
std::string page_of(const Json& data);

/// JSON that may stand inside a <script> element: no text of the user can end it or begin a comment.
std::string embedded(const Json& data);
/// Text between HTML tags.
std::string escaped(const std::string& text);
/// `@name@` in the template becomes the value of that name; values are not searched again.
std::string filled(const std::string& page, const std::vector<std::pair<std::string, std::string>>& values);

/// A table as columns: numbers exact (base64 of doubles) where every cell is one, else texts.
Json columns_of(const CsvTable& table, const Json& units, std::span<const std::size_t> rows);
/// What stands in these rows.
template <class Value>
std::vector<Value> chosen(const std::vector<Value>& all, std::span<const std::size_t> rows) {
  std::vector<Value> out;
  for (const std::size_t row : rows) out.push_back(all[row]);
  return out;
}
/// At most `most` of `count` rows, evenly spread, with all of `wanted`.
std::vector<std::size_t> kept_rows(std::size_t count, std::size_t most,
                                   const std::vector<std::size_t>& wanted);

/// Events of `log.jsonl`, its accepted steps and when it began and ended.
Json data_of_log(const std::filesystem::path& file, const Limits& limits);

/// Geometry and fields of the stored steps, of which `thinned` chooses.
Json data_of_blocks(const ResultsReader& results, int peak_step, const Limits& limits);
/// Which of the items of these sizes are shown: as many as fit, evenly spread, with the first, the last and
/// `must`.
std::vector<std::size_t> thinned(std::span<const std::size_t> sizes, std::size_t room, std::size_t must);

/// A JSON file, null when it is absent; what is wrong with it goes to `notices`.
Json read_json(const std::filesystem::path& file, Json& notices);
/// The beginning of a text file, "" when it is absent.
std::string read_text(const std::filesystem::path& file, std::size_t most);

}  // namespace dda::report
