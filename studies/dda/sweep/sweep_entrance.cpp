#include "studies/dda/sweep/sweep_entrance.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "framework/files/run/seal.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/provenance.hpp"
#include "framework/messages/tell.hpp"
#include "studies/dda/sweep/sweep_cases.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr auto between_tries = std::chrono::milliseconds(100);
constexpr double leases_to_arrange = 5;  ///< no sign of life is given meanwhile

fs::path all_claims(const fs::path& folder) { return folder / "claims"; }

/// Says once for whom this process waits.
class WaitingNote {
 public:
  void show(const Claim& claim) {
    if (!is_shown_) tell(stderr, "waiting for {}, or its next sign of life\n", owner_text(claim));
    is_shown_ = true;
  }

 private:
  bool is_shown_ = false;
};

/// One process at a time arranges a folder.
class Arranging {
 public:
  Arranging(const fs::path& folder, double lease) : claims_(all_claims(folder), leases_to_arrange * lease) {
    WaitingNote note;
    for (;; std::this_thread::sleep_for(between_tries)) {
      const auto& claims = claims_.look();
      if (auto claim = claims_.take("arrangement", {{"since", utc_now()}})) {
        claim_ = std::move(*claim);
        return;
      }
      if (const auto other = claims.find("arrangement");
          other != claims.end() && other->second.holder == Holder::silent)
        note.show(other->second);
    }
  }
  ~Arranging() {
    try {
      claims_.end(claim_, Json::object());
    } catch (const OutputError&) {  // then it ends with this process
    }
  }
  Arranging(const Arranging&) = delete;
  Arranging& operator=(const Arranging&) = delete;

 private:
  Claims claims_;
  Claim claim_;
};

bool is_arranged(const fs::path& folder, const Sweep& sweep) {
  return fs::is_directory(claims_folder(folder, sweep)) && fs::exists(folder / "sweep.yaml") &&
         read_whole(folder / "sweep.yaml") == sweep.text;
}

std::vector<fs::path> folders_in(const fs::path& parent) {
  std::vector<fs::path> out;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, error))
    if (entry.is_directory()) out.push_back(entry.path());
  return out;
}

/// The claims among these of which it cannot be told whether anybody holds them. Throws when somebody does.
std::vector<Claim> doubtful(const fs::path& folder, const std::map<std::string, Claim>& claims) {
  std::vector<Claim> out;
  for (const auto& [name, claim] : claims) {
    if (claim.holder == Holder::alive)
      throw InputError(
          Position{folder.string()},
          fmt::format("{} is at work on the sweep as it was before; stop it or wait for its end, or "
                      "choose another --folder",
                      owner_text(claim)));
    if (claim.holder == Holder::silent) out.push_back(claim);
  }
  return out;
}

/// Throws when other processes are at work; waits for a lease while it cannot tell.
void refuse_others(const fs::path& folder, double lease) {
  for (const fs::path& place : folders_in(all_claims(folder))) {
    Claims claims(place, lease);
    WaitingNote note;
    for (auto left = doubtful(folder, claims.look()); !left.empty(); left = doubtful(folder, claims.look())) {
      note.show(left.front());
      std::this_thread::sleep_for(between_tries);
    }
  }
}

void make(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("cannot use '{}': {}", folder.string(), error.message()));
}

void arrange(const fs::path& folder, const Sweep& sweep, const Entrance& entrance) {
  const Earlier earlier = examine(folder, sweep);
  if (!entrance.overwrite) refuse_loss(folder, sweep, earlier);
  refuse_others(folder, entrance.lease);
  if (entrance.overwrite) RunFolder::create(folder, IfExists::overwrite);
  std::error_code error;
  for (const fs::path& place : folders_in(all_claims(folder))) fs::remove_all(place, error);
  place_cases(folder, sweep, earlier, entrance.overwrite);
  write_whole(folder / "sweep.yaml", sweep.text, Flush::to_system);
  make(claims_folder(folder, sweep));
}

}  // namespace

fs::path claims_folder(const fs::path& folder, const Sweep& sweep) {
  std::string decks;
  for (const SweepCase& one : sweep.cases) decks += one.effective;
  return all_claims(folder) / fmt::format("{}-{}", sweep.cases.size(), checksum_of(decks));
}

Claims enter_sweep(const fs::path& folder, const Sweep& sweep, const Entrance& entrance) {
  make_writable(
      all_claims(folder));  // at no time is there a folder that looks like something else than a sweep
  if (entrance.overwrite || !is_arranged(folder, sweep)) {
    const Arranging arranging(folder, entrance.lease);
    if (entrance.overwrite || !is_arranged(folder, sweep)) arrange(folder, sweep, entrance);
  }
  return {claims_folder(folder, sweep), entrance.lease};
}

}  // namespace dda
