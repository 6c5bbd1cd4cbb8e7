#include "studies/dda/sweep/sweep_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "framework/files/run/run_folder.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr int fewest_digits = 3;

/// An effective deck without the comment that names version, file and overrides.
std::string body(const fs::path& file) {
  const std::string text = read_whole(file);
  std::size_t begin = 0;
  while (begin < text.size() && text[begin] == '#')
    begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  return text.substr(begin);
}

/// Run folders below `cases`, by what they compute, in the order of their names.
std::multimap<std::string, fs::path> run_folders(const fs::path& cases) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(cases, error))
    if (fs::exists(entry.path() / "effective_deck.yaml")) folders.push_back(entry.path());
  std::ranges::sort(folders);
  std::multimap<std::string, fs::path> out;
  for (const fs::path& folder : folders) out.emplace(body(folder / "effective_deck.yaml"), folder);
  return out;
}

/// With runs alone below `cases` somebody has done what `--dry-run` prints.
bool is_sweep_folder(const fs::path& folder) {
  return fs::exists(folder / "sweep.json") || fs::is_directory(folder / "cases") ||
         fs::is_directory(folder / "claims");
}

/// Null when there is no such file or it is no JSON.
Json json_of(const fs::path& file) {
  if (!fs::exists(file)) return {};
  Json out = Json::parse(read_whole(file), nullptr, false);
  return out.is_object() ? out : Json();
}

bool is_empty_or_absent(const fs::path& folder) {
  std::error_code error;
  return !fs::exists(folder, error) || (fs::is_directory(folder, error) && fs::is_empty(folder, error));
}

void move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::remove(to, error);  // an empty folder stands in the way, one with something in it stays
  fs::rename(from, to, error);
  if (error)
    throw OutputError(
        fmt::format("cannot move '{}' to '{}': {}", from.string(), to.string(), error.message()));
}

/// In two steps, because cases may change places; each step leaves every run where `examine` finds it.
void move_kept(const fs::path& folder, const Sweep& sweep, const Earlier& earlier) {
  std::vector<std::pair<fs::path, fs::path>> second;
  for (std::size_t i = 0; i < earlier.kept.size(); ++i) {
    const fs::path wanted = folder / case_folder(sweep, i);
    if (earlier.kept[i].empty() || earlier.kept[i] == wanted) continue;
    const fs::path aside = wanted.parent_path() / (".moving-" + wanted.filename().string());
    move(earlier.kept[i], aside);
    second.emplace_back(aside, wanted);
  }
  for (const auto& [aside, wanted] : second) move(aside, wanted);
}

}  // namespace

void refuse_loss(const fs::path& folder, const Sweep& sweep, const Earlier& earlier) {
  if (!is_empty_or_absent(folder) && !is_sweep_folder(folder))
    throw InputError(Position{folder.string()},
                     "the folder exists and holds no sweep; choose another one or give --overwrite");
  if (earlier.others.empty()) return;
  throw InputError(
      Position{folder.string()},
      fmt::format(
          "{} of its runs {} no longer in {}, {} for one; choose another --folder, remove them, or give "
          "--overwrite to start all anew",
          earlier.others.size(), earlier.others.size() == 1 ? "is" : "are", sweep.file.string(),
          earlier.others.front().string()));
}

std::string name_of(CaseStatus status) {
  switch (status) {
    case CaseStatus::pending:
      return "pending";
    case CaseStatus::running:
      return "running";
    case CaseStatus::goal_reached:
      return "goal_reached";
    case CaseStatus::stopped_early:
      return "stopped_early";
    case CaseStatus::interrupted:
      return "interrupted";
    case CaseStatus::failed:
      break;
  }
  return "failed";
}

fs::path case_folder(const Sweep& sweep, std::size_t index) { return case_folder(sweep.cases.size(), index); }

fs::path case_folder(std::size_t num_cases, std::size_t index) {
  const int digits = static_cast<int>(std::to_string(num_cases).size());
  return fs::path("cases") / fmt::format("{:0{}}", index + 1, std::max(digits, fewest_digits));
}

CaseState state_of(const fs::path& run_folder) {
  CaseState out;
  out.curve_units = json_of(run_folder / "curve.units.json");
  out.can_resume = fs::exists(run_folder / "restart.h5");
  out.summary = json_of(run_folder / "summary.json");
  if (!out.summary.is_object()) return out;
  const std::string status = out.summary.value("status", "");
  out.reason = out.summary.value("reason", "");
  for (const CaseStatus known :
       {CaseStatus::goal_reached, CaseStatus::stopped_early, CaseStatus::interrupted})
    if (name_of(known) == status) out.status = known;
  if (out.has_result()) out.exit_code = out.status == CaseStatus::goal_reached ? 0 : 3;
  out.can_resume = out.can_resume && !out.has_result();
  return out;
}

std::size_t Earlier::num_kept() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(kept, [](const fs::path& folder) { return !folder.empty(); }));
}

Earlier examine(const fs::path& folder, const Sweep& sweep) {
  Earlier out;
  out.kept.resize(sweep.cases.size());
  if (fs::exists(folder / "sweep.yaml")) out.has_changed = read_whole(folder / "sweep.yaml") != sweep.text;
  auto found = run_folders(folder / "cases");
  const auto take = [&](std::size_t i, bool same_place) {
    const auto [first, last] = found.equal_range(sweep.cases[i].effective);
    const auto one = std::find_if(first, last, [&](const auto& entry) {
      return !same_place || entry.second == folder / case_folder(sweep, i);
    });
    if (one == last) return;
    out.kept[i] = one->second;
    found.erase(one);
  };
  for (const bool same_place : {true, false})
    for (std::size_t i = 0; i < sweep.cases.size(); ++i)
      if (out.kept[i].empty()) take(i, same_place);
  for (const auto& [effective, left] : found) out.others.push_back(left);
  std::ranges::sort(out.others);
  return out;
}

fs::path default_sweep_folder(const fs::path& file) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path wanted =
      default_run_folder(whole.stem() == "sweep" ? whole.parent_path() / "deck.yaml" : file);
  fs::path candidate = wanted;
  for (int number = 2; !is_empty_or_absent(candidate) && !is_sweep_folder(candidate); ++number)
    candidate = fmt::format("{}-{}", wanted.string(), number);
  return candidate;
}

void place_cases(const fs::path& folder, const Sweep& sweep, const Earlier& earlier, bool overwrite) {
  std::error_code error;
  if (overwrite && fs::exists(folder / "sweep.json")) fs::remove_all(folder / "cases", error);
  if (!error) fs::create_directories(folder / "cases", error);
  if (error)
    throw OutputError(fmt::format("cannot use '{}': {}", (folder / "cases").string(), error.message()));
  if (!overwrite) move_kept(folder, sweep, earlier);
}

}  // namespace dda
