#include "studies/dda/sweep/sweep_cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/messages/provenance.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

bool is_over(const CaseState& state) { return state.has_result() || state.status == CaseStatus::failed; }

Json outcome_of(const CaseState& state) {
  return {{"status", name_of(state.status)},
          {"exit_code", state.exit_code ? Json(*state.exit_code) : Json()},
          {"reason", state.reason},
          {"at", utc_now()}};
}

std::string text_in(const Json& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return json.is_object() && found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

std::optional<int> exit_code_in(const Json& outcome) {
  const auto found = outcome.find("exit_code");
  if (found == outcome.end() || !found->is_number_integer()) return {};
  return found->get<int>();
}

bool has_failed(const Claim& claim) {
  return claim.holder == Holder::ended && text_in(claim.outcome, "status") == name_of(CaseStatus::failed);
}

/// A run may still be ending whose sweep has died.
bool is_written_in(const fs::path& run_folder) { return !FolderLock::try_lock(run_folder); }

}  // namespace

std::string owner_text(const Claim& claim) {
  if (claim.owner.number == 0) return "a process that has not given its name";
  return fmt::format("process {} of {}, since {} by its clock", claim.owner.number, claim.owner.host,
                     text_in(claim.note, "since"));
}

CaseState claimed_state(const fs::path& run_folder, const Claim& claim) {
  CaseState out = state_of(run_folder);
  if (claim.is_held()) {
    out.status = CaseStatus::running;
    out.reason.clear();
    out.exit_code.reset();
    out.summary = Json();
  } else if (has_failed(claim)) {
    out.status = CaseStatus::failed;
    out.reason = text_in(claim.outcome, "reason");
    out.exit_code = exit_code_in(claim.outcome);
    out.summary = Json();
  } else if (!out.has_result() && text_in(claim.outcome, "status") == name_of(CaseStatus::interrupted)) {
    out.status = CaseStatus::interrupted;
    out.reason = text_in(claim.outcome, "reason");
    out.exit_code = exit_code_in(claim.outcome);
  }
  return out;
}

SweepCases::SweepCases(const Sweep& sweep, fs::path folder, Claims claims, SharedWork work)
    : sweep_(sweep),
      folder_(std::move(folder)),
      claims_(std::move(claims)),
      work_(std::move(work)),
      states_(sweep.cases.size()),
      seen_(sweep.cases.size()),
      forgiven_(sweep.cases.size()) {
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (is_wanted(i)) states_[i] = state_of(folder_ / case_folder(sweep_, i));
  claims_.look();
  forgive_failures();
  refresh();
}

SweepCases::~SweepCases() {
  if (!waiting_) return;
  try {
    claims_.end(*waiting_, Json::object());
  } catch (const OutputError&) {  // then it ends with this process
  }
}

std::string SweepCases::name(std::size_t index) const {
  return case_folder(sweep_, index).filename().string();
}

void SweepCases::forgive_failures() {
  const auto& claims = claims_.seen();
  const bool are_others_at_work =
      std::ranges::any_of(claims, [](const auto& entry) { return entry.second.is_held(); });
  if (are_others_at_work && !work_.only_case) return;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const auto found = claims.find(name(i));
    if (found == claims.end()) continue;
    const bool is_same_attempt =
        !work_.attempt.empty() && text_in(found->second.note, "attempt") == work_.attempt;
    if (!is_same_attempt) forgiven_[i] = found->second.generation;
  }
}

CaseState SweepCases::state_under(std::size_t index, const Claim& claim) const {
  const fs::path where = folder_ / case_folder(sweep_, index);
  const bool is_forgiven = claim.generation <= forgiven_[index] && !claim.is_held();
  return is_forgiven ? state_of(where) : claimed_state(where, claim);
}

bool SweepCases::refresh() {
  if (waiting_) beat(claims_.files_of(*waiting_), ++waiting_->beats);
  for (const std::size_t i : ready_) beat(claims_.files_of(mine_.at(i)), ++mine_.at(i).beats);
  const auto& claims = claims_.look();
  bool has_changed = false;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (mine_.contains(i)) continue;
    const auto found = claims.find(name(i));
    const Seen now = found == claims.end() ? Seen{} : Seen{found->second.generation, found->second.is_held()};
    if (now == seen_[i]) continue;
    seen_[i] = now;
    states_[i] =
        found == claims.end() ? state_of(folder_ / case_folder(sweep_, i)) : state_under(i, found->second);
    has_changed = true;
  }
  return has_changed;
}

bool SweepCases::may_start(std::size_t index) const {
  return is_wanted(index) && !is_over(states_[index]) && states_[index].status != CaseStatus::running;
}

std::optional<std::size_t> SweepCases::take_next() {
  if (const auto taken = take_ready()) return taken;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!may_start(i)) continue;
    take(i);
    if (const auto taken = take_ready()) return taken;
  }
  return {};
}

void SweepCases::take(std::size_t index) {
  auto claim = claims_.take(name(index), {{"attempt", work_.attempt}, {"since", utc_now()}});
  states_[index].status = CaseStatus::running;
  seen_[index] = {-1, false};  // looked at again by the next `refresh` unless it is claimed
  if (!claim) return;
  mine_.emplace(index, std::move(*claim));
  ready_.insert(index);
}

/// Between the last look at a case and its claim another process may have run it. The lock is tried by the owner of
/// the claim alone, or it would stand in the way of a run that begins.
std::optional<std::size_t> SweepCases::take_ready() {
  const auto ready = std::ranges::find_if(
      ready_, [&](std::size_t i) { return !is_written_in(folder_ / case_folder(sweep_, i)); });
  if (ready == ready_.end()) return {};
  const std::size_t index = *ready;
  ready_.erase(ready);
  CaseState found = state_of(folder_ / case_folder(sweep_, index));
  if (found.has_result()) {
    end(index, std::move(found));
    return {};
  }
  states_[index] = std::move(found);
  states_[index].status = CaseStatus::running;
  return index;
}

void SweepCases::let_go() {
  while (!ready_.empty()) {
    const std::size_t index = *ready_.begin();
    ready_.erase(ready_.begin());
    end(index, state_of(folder_ / case_folder(sweep_, index)));
  }
}

void SweepCases::end(std::size_t index, CaseState state) {
  Claim& claim = mine_.at(index);
  claims_.end(claim, outcome_of(state));
  seen_[index] = {claim.generation, false};
  states_[index] = std::move(state);
  mine_.erase(index);
}

void SweepCases::lose(std::size_t index) {
  mine_.erase(index);
  seen_[index] = {-1, false};
  refresh();
}

bool SweepCases::are_over() const {
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (is_wanted(i) && !is_over(states_[i])) return false;
  return true;
}

bool SweepCases::wait_for_all() {
  if (!waiting_) waiting_ = claims_.take("all", {{"since", utc_now()}});
  return waiting_.has_value();
}

std::string SweepCases::holder_of(std::size_t index) const {
  const auto found = claims_.seen().find(name(index));
  const bool is_others = found != claims_.seen().end() && found->second.is_held() && !mine_.contains(index);
  return is_others ? owner_text(found->second) : "";
}

}  // namespace dda
