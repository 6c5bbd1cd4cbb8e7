#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/files/claims.hpp"
#include "studies/dda/sweep/sweep_folder.hpp"

namespace dda {

/// What a process wants of the sweep that it shares with others.
struct SharedWork {
  std::string attempt = {};                   ///< name of what several processes do together; "" = none
  std::optional<std::size_t> only_case = {};  ///< from 0; all when empty
};

/// The cases of a sweep as its folder tells them, and those that this process has claimed.
///
/// Whoever claims a case (claims.hpp) runs it and says in the claim how it ended. A case may be claimed while it has
/// no result and nobody runs it: nobody has, its run was interrupted, or its owner is dead. One that failed is tried
/// again if it failed before this process began, unless other processes were at work then or it failed in the attempt
/// that this process belongs to: what they do together is one try.
class SweepCases {
 public:
  SweepCases(const Sweep& sweep, std::filesystem::path folder, Claims claims, SharedWork work);
  ~SweepCases();
  SweepCases(const SweepCases&) = delete;
  SweepCases& operator=(const SweepCases&) = delete;

  const std::vector<CaseState>& states() const { return states_; }
  /// Reads anew what has changed, and says whether anything has.
  bool refresh();
  /// Claims the first case that may be; nothing when there is none now.
  std::optional<std::size_t> take_next();
  /// Of a case that this process has claimed.
  Claim& claim(std::size_t index) { return mine_.at(index); }
  const Claims& claims() const { return claims_; }
  /// Says how a case that this process has claimed ended.
  void end(std::size_t index, CaseState state);
  /// Gives back what this process has claimed and not begun.
  void let_go();
  /// A case that this process had claimed is another one's.
  void lose(std::size_t index);
  /// Whether no case is left to be run, by this process or another one.
  bool are_over() const;
  /// Whether it is for this process to wait for what others still run; one of those that ask does.
  bool wait_for_all();
  /// Who runs a case, "" when this process does or nobody.
  std::string holder_of(std::size_t index) const;

 private:
  struct Seen {
    int generation = 0;
    bool is_held = false;
    bool operator==(const Seen&) const = default;
  };

  std::string name(std::size_t index) const;
  bool is_wanted(std::size_t index) const { return !work_.only_case || *work_.only_case == index; }
  bool may_start(std::size_t index) const;
  void forgive_failures();
  CaseState state_under(std::size_t index, const Claim& claim) const;
  void take(std::size_t index);
  std::optional<std::size_t> take_ready();

  const Sweep& sweep_;
  const std::filesystem::path folder_;
  Claims claims_;
  SharedWork work_;
  std::vector<CaseState> states_;
  std::vector<Seen> seen_;
  std::vector<int> forgiven_;  ///< generation up to which a failure does not count
  std::map<std::size_t, Claim> mine_;
  std::set<std::size_t> ready_;  ///< of `mine_`, those to be run
  std::optional<Claim> waiting_;
};

/// How the owner of a claim is named: "process 4711 of HOST, since 2026-01-31T12:00:00.000Z by its clock".
std::string owner_text(const Claim& claim);

/// State of a case whose newest claim is known: what its folder says, unless the claim's owner is at work or has said
/// that it failed.
CaseState claimed_state(const std::filesystem::path& run_folder, const Claim& claim);

}  // namespace dda
