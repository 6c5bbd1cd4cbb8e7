#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "framework/base/process_id.hpp"

namespace dda {

/// What is known of whoever has made a claim.
enum class Holder {
  alive,   ///< a process of this machine, or one that has given a sign of life
  silent,  ///< of another machine, not looked at for long enough
  dead,    ///< a process of this machine that is gone, or no sign of life for the whole lease
  ended    ///< has said how it ended
};

/// A claim on a name, as its file holds it.
struct Claim {
  std::string name;
  int generation = 0;                    ///< from 1; each claim on a name takes the next
  ProcessId owner;                       ///< number 0 where the file is not whole
  std::uint64_t beats = 0;               ///< signs of life
  double lease = 0;                      ///< without a sign of life for that long the owner is dead [s]
  nlohmann::ordered_json note, outcome;  ///< as given by the owner; outcome null until it has ended
  Holder holder = Holder::silent;

  bool is_held() const { return holder == Holder::alive || holder == Holder::silent; }
};

/// The file of a claim, and the one that is there as soon as somebody else has taken over.
struct ClaimFiles {
  std::filesystem::path own, next;
};

/// Another sign of life, `beats` being the number of all; whether the claim is still the caller's. Calls only what
/// is allowed between fork and exec (signal-safety(7)).
bool beat(const ClaimFiles& files, std::uint64_t beats) noexcept;

/// Claims of processes on names, in a folder that any number of machines may share.
///
/// Generation g of a claim on NAME is the file NAME.g: a line of JSON that says who made it and counts its signs
/// of life, then a line that says how it ended. A file is created exclusively (open(2), O_EXCL, which NFS keeps to)
/// and never removed, so one process alone gets each generation; nobody asks for the next before the last has ended
/// or its owner is dead. Clocks of different machines are never compared: dead is whose beats have not changed over
/// the lease, by this process's own steady clock. A folder is opened before its files are looked at, which makes NFS
/// ask its server.
class Claims {
 public:
  /// The folder need not exist to be looked at.
  Claims(std::filesystem::path folder, double lease) : folder_(std::move(folder)), lease_(lease) {}

  /// The newest claim on every name, as it stands now.
  const std::map<std::string, Claim>& look();
  const std::map<std::string, Claim>& seen() const { return claims_; }

  /// The next claim on a name, made for this process; nothing when its last one is held or another process is
  /// faster. Throws OutputError, and leaves nothing behind, when it cannot be written.
  std::optional<Claim> take(const std::string& name, const nlohmann::ordered_json& note);
  /// From here on the claim lives and dies with another process of this machine.
  void hand_over(Claim& claim, pid_t process) const;
  void end(Claim& claim, const nlohmann::ordered_json& outcome) const;
  ClaimFiles files_of(const Claim& claim) const;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Sign {
    int generation = 0;
    std::uint64_t beats = 0;
    Clock::time_point since;
    bool has_beaten = false;
  };

  Holder judge(const Claim& claim);

  std::filesystem::path folder_;
  double lease_;
  std::map<std::string, Claim> claims_;
  std::map<std::string, Sign> signs_;
};

}  // namespace dda
