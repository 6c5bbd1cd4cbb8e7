#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/deck/schema.hpp"
#include "framework/files/run/run_folder.hpp"
#include "studies/dda/sweep/description/sweep.hpp"

namespace dda {

/// How far a case of a sweep is.
enum class CaseStatus { pending, running, goal_reached, stopped_early, interrupted, failed };

/// "pending", "goal_reached", ...: what sweep.json and sweep.csv call it.
std::string name_of(CaseStatus status);

/// A case's outcome so far.
struct CaseState {
  CaseStatus status = CaseStatus::pending;
  std::string reason;            ///< of the run, or the last line that a failed one wrote to standard error
  std::optional<int> exit_code;  ///< of the process
  bool can_resume = false;       ///< its folder has a restart file and no result
  Json summary;                  ///< null when there is none
  Json curve_units;              ///< unit of each column of its curve

  bool has_result() const {
    return status == CaseStatus::goal_reached || status == CaseStatus::stopped_early;
  }
};

/// "cases/007": the folder of case `index` (from 0) within the sweep's; three digits, more for 1000 cases.
std::filesystem::path case_folder(const Sweep& sweep, std::size_t index);
std::filesystem::path case_folder(std::size_t num_cases, std::size_t index);

/// What a run folder holds: a result, something to go on with, or nothing.
CaseState state_of(const std::filesystem::path& run_folder);

/// What an earlier sweep left in a folder, compared by the effective decks, so that numbers may change.
struct Earlier {
  bool has_changed = false;                   ///< its file was another one
  std::vector<std::filesystem::path> kept;    ///< run folder of each case, empty when there is none
  std::vector<std::filesystem::path> others;  ///< run folders that belong to no case any more
  std::size_t num_kept() const;
};

/// Changes nothing.
Earlier examine(const std::filesystem::path& folder, const Sweep& sweep);

/// Where a sweep goes unless told otherwise: runs/NAME as for a run, NAME being that of the folder for
/// `sweep.yaml` too; NAME-2, ... when that is taken by something else than a sweep.
std::filesystem::path default_sweep_folder(const std::filesystem::path& file);

/// Throws InputError when a folder holds something else, or runs that are no longer in the sweep.
void refuse_loss(const std::filesystem::path& folder, const Sweep& sweep, const Earlier& earlier);

/// Moves what is kept to where its case belongs; with `overwrite` removes every case of an earlier sweep.
void place_cases(const std::filesystem::path& folder, const Sweep& sweep, const Earlier& earlier,
                 bool overwrite);

}  // namespace dda
