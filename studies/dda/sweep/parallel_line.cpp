#include "studies/dda/sweep/parallel_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "framework/deck/settings.hpp"
#include "studies/dda/sweep/processes.hpp"
#include "studies/dda/sweep/sweep_folder.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// As a shell wants a word that it must not change.
std::string quoted(const std::string& word) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./,:=@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string line_of(const Words& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + quoted(word);
  return out;
}

/// Runs side by side leave the processors to one another.
std::string setting() { return "OMP_NUM_THREADS=" + quoted(threads_of_processes()) + " "; }

/// Whether every case is told the same, but for the values: only seeds may stand at different places.
bool are_alike(const Sweep& sweep) {
  const SweepCase& first = sweep.cases.front();
  return std::ranges::all_of(sweep.cases, [&](const SweepCase& one) { return one.seeds == first.seeds; });
}

/// Whether parallel would put something else in the place of a part of a word, as of `{}` or `{1}`.
bool has_place(const std::string& word) {
  for (auto brace = word.find('{'); brace != std::string::npos; brace = word.find('{', brace + 1))
    if (brace + 1 == word.size() || std::isalpha(static_cast<unsigned char>(word[brace + 1])) == 0)
      return true;
  return false;
}

/// One command with the places of parallel's words in it.
class Template {
 public:
  Template(const Sweep& sweep, const fs::path& folder) : sweep_(sweep), folder_(folder) {}

  /// Whether no place is in it but those for the values.
  bool is_right() const {
    Words words = fixed();
    for (const auto& [path, k] : varied()) words.push_back(path);
    words.push_back(sweep_.cases.front().deck.string());
    words.push_back(folder_.string());
    return std::ranges::none_of(words, has_place);
  }

  std::string line(int jobs) const {
    Words words{"parallel", "-j", std::to_string(jobs), "--will-cite", program_file(), "run"};
    const std::size_t deck = place_of("deck");
    const bool has_decks = deck < sweep_.keys().size();
    std::string out = setting() + line_of(words) + " " +
                      (has_decks ? place(deck) : inner(sweep_.cases.front().deck.string()));
    const auto digits = case_folder(sweep_, 0).filename().string().size();
    out += " --quiet --folder " + inner((folder_ / "cases").string() + "/") +
           fmt::format("'{{=1 $_=sprintf(\"%0{}d\",seq()) =}}'", digits);
    for (const std::string& option : options_of_processes()) out += " " + option;
    for (const std::string& text : fixed()) out += " --set " + inner(text);
    for (const auto& [path, k] : varied()) out += " --set " + inner(path + "=") + place(k);
    return out + arguments();
  }

 private:
  /// A word of a command that parallel hands to a shell once more.
  static std::string inner(const std::string& word) {
    const std::string once = quoted(word);
    return once == word ? word : quoted(once);
  }
  /// Where parallel puts the value of a key.
  static std::string place(std::size_t key) { return fmt::format("{{{}}}", key + 1); }

  std::size_t place_of(const std::string& name) const {
    const auto keys = sweep_.keys();
    return static_cast<std::size_t>(std::ranges::find(keys, name, &SweptKey::name) - keys.begin());
  }

  /// What does not vary: everything before the first varied key.
  Words fixed() const {
    const Words& all = sweep_.cases.front().overrides;
    return {all.begin(), all.end() - static_cast<std::ptrdiff_t>(varied().size())};
  }

  std::vector<std::pair<std::string, std::size_t>> varied() const {
    const auto keys = sweep_.keys();
    std::vector<std::pair<std::string, std::size_t>> out;
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (keys[k].name != "deck" && keys[k].name != "seed") out.emplace_back(keys[k].name, k);
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (keys[k].name == "seed")
        for (const std::string& path : sweep_.cases.front().seeds) out.emplace_back(path, k);
    return out;
  }

  std::string arguments() const {
    std::string out;
    for (const Axis& axis : sweep_.axes)
      for (std::size_t k = 0; k < axis.keys.size(); ++k) {
        out += k == 0 ? " :::" : " :::+";
        for (const Node& value : axis.keys[k].values) out += " " + quoted(text_of(axis.keys[k], value));
      }
    return out;
  }

  std::string text_of(const SweptKey& key, const Node& value) const {
    if (key.name != "deck") return to_flow_yaml(value);
    return (sweep_.file.parent_path() / value.text).lexically_normal().string();
  }

  const Sweep& sweep_;
  const fs::path& folder_;
};

std::string one_by_one(const Sweep& sweep, const fs::path& folder, int jobs) {
  std::string out = setting() + fmt::format("parallel -j {} --will-cite :::", jobs);
  for (std::size_t i = 0; i < sweep.cases.size(); ++i) {
    Words words{program_file(), "run",      sweep.cases[i].deck.string(),
                "--quiet",      "--folder", (folder / case_folder(sweep, i)).string()};
    for (const std::string& option : options_of_processes()) words.push_back(option);
    for (const std::string& text : sweep.cases[i].overrides) {
      words.emplace_back("--set");
      words.push_back(text);
    }
    out += " " + quoted(line_of(words));
  }
  return out;
}

}  // namespace

std::string parallel_line(const Sweep& sweep, const fs::path& folder, int jobs) {
  const Template command(sweep, folder);
  return are_alike(sweep) && command.is_right() ? command.line(jobs) : one_by_one(sweep, folder, jobs);
}

}  // namespace dda
