#include "studies/dda/sweep/launch/sweep_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "framework/deck/changes/settings.hpp"
#include "framework/files/whole_file.hpp"
#include "studies/dda/sweep/sweep_cases.hpp"
#include "studies/dda/sweep/sweep_progress.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr std::array kinds = {"done", "running", "waiting", "failed"};

/// A case as sweep.json names it.
struct NamedCase {
  std::string folder, settings;
};

/// The one folder of claims; one that does not exist while a sweep is being arranged, or was run by an earlier version.
fs::path claims_of(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "claims", error))
    if (entry.is_directory()) return entry.path();
  return folder / "claims" / "none";
}

/// Of a sweep whose cases are run one by one (`--case`, or lines of `--dry-run`), which has no sweep.json: as many as its folder
/// of claims says, or those that have a folder. Their settings are not known.
std::vector<NamedCase> cases_one_by_one(const fs::path& folder) {
  std::vector<NamedCase> out;
  const std::string claims = claims_of(folder).filename();
  std::size_t count = 0;
  std::from_chars(claims.data(), claims.data() + claims.size(), count);
  for (std::size_t i = 0; i < count; ++i) out.push_back({case_folder(count, i), ""});
  if (count > 0) return out;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "cases", error))
    if (entry.is_directory()) out.push_back({fs::path("cases") / entry.path().filename(), ""});
  std::ranges::sort(out, {}, &NamedCase::folder);
  return out;
}

std::vector<NamedCase> cases_in(const fs::path& folder) {
  const fs::path file = folder / "sweep.json";
  if (!fs::exists(file)) {
    std::vector<NamedCase> out = cases_one_by_one(folder);
    if (!out.empty()) return out;
    throw InputError(Position{folder.string()},
                     "holds no sweep, it has no sweep.json; `dda sweep FILE` makes one");
  }
  const Json sweep = Json::parse(read_whole(file), nullptr, false);
  const Json cases = sweep.is_object() ? sweep.value("cases", Json()) : Json();
  if (!cases.is_array())
    throw InputError(Position{file.string()}, "names no cases; `dda sweep FILE` writes it anew");
  std::vector<NamedCase> out;
  for (const Json& one : cases) {
    NamedCase named{one.value("folder", ""), ""};
    const Json settings = one.value("settings", Json::object());
    for (const auto& [key, value] : settings.items())
      named.settings += fmt::format("{}{}={}", named.settings.empty() ? "" : ", ", key,
                                    value.is_string() ? value.get<std::string>() : value.dump());
    out.push_back(std::move(named));
  }
  return out;
}

std::string kind_of(const CaseState& state) {
  if (state.has_result()) return "done";
  if (state.status == CaseStatus::running) return "running";
  return state.status == CaseStatus::failed ? "failed" : "waiting";
}

class StatusTable {
 public:
  explicit StatusTable(const fs::path& folder) : folder_(folder), claims_(claims_of(folder), 0) {
    claims_.look();
    for (const NamedCase& one : cases_in(folder)) add(one);
  }

  std::string text() const {
    std::size_t all = 0;
    std::string counts, lines;
    for (const char* kind : kinds) {
      const auto found = lines_.find(kind);
      if (found == lines_.end()) continue;
      all += found->second.count;
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", found->second.count, kind);
      if (!found->second.text.empty()) lines += fmt::format("{}\n{}", kind, found->second.text);
    }
    return fmt::format("{}: {} case{}: {}\n{}", folder_.string(), all, all == 1 ? "" : "s", counts, lines);
  }

 private:
  struct Lines {
    std::size_t count = 0;
    std::string text;
  };

  void add(const NamedCase& one) {
    const fs::path where = folder_ / one.folder;
    const auto found = claims_.seen().find(where.filename().string());
    const Claim* const claim = found == claims_.seen().end() ? nullptr : &found->second;
    const CaseState state = claim ? claimed_state(where, *claim) : state_of(where);
    Lines& lines = lines_[kind_of(state)];
    ++lines.count;
    const std::string said = remark(where, state, claim);
    if (!said.empty())
      lines.text += fmt::format("  {}  {}{}{}\n", where.filename().string(), one.settings,
                                one.settings.empty() ? "" : "  ", said);
  }

  static std::string remark(const fs::path& where, const CaseState& state, const Claim* claim) {
    if (state.status == CaseStatus::running && claim) {
      const std::string step = last_step(where);
      return owner_text(*claim) + (step.empty() ? "" : ", step " + step);
    }
    if (state.status == CaseStatus::failed)
      return fmt::format("exit code {}: {}", state.exit_code.value_or(4), state.reason);
    if (state.has_result() || !claim) return "";
    return claim->holder == Holder::dead ? "left by " + owner_text(*claim) + ", which is dead"
                                         : "interrupted";
  }

  fs::path folder_;
  Claims claims_;
  std::map<std::string, Lines> lines_;
};

}  // namespace

std::string sweep_status_text(const fs::path& folder) { return StatusTable(folder).text(); }

}  // namespace dda
