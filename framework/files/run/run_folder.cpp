#include "framework/files/run/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "framework/base/errors.hpp"
#include "framework/files/file_writer.hpp"
#include "framework/files/run/results.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw OutputError(fmt::format("cannot use the run folder '{}': {}", folder.string(), why));
}

bool is_taken(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return false;
  return !fs::is_directory(folder, error) || !fs::is_empty(folder, error);
}

/// With a separator at its end a path has an empty last part; numbering needs the name.
fs::path without_trailing_separator(const fs::path& path) {
  return path.has_filename() || !path.has_parent_path() ? path : path.parent_path();
}

fs::path numbered(const fs::path& wanted, int number) {
  return fs::path(wanted).replace_filename(fmt::format("{}-{}", wanted.filename().string(), number));
}

fs::path first_free(const fs::path& wanted) {
  if (!is_taken(wanted)) return wanted;
  for (int number = 2;; ++number) {
    if (const fs::path candidate = numbered(wanted, number); !is_taken(candidate)) return candidate;
  }
}

/// The folders above and including `folder` that do not exist yet, innermost first.
std::vector<fs::path> missing_folders(fs::path folder) {
  std::vector<fs::path> missing;
  std::error_code error;
  while (!folder.empty() && !fs::exists(folder, error)) {
    missing.push_back(folder);
    folder = folder.parent_path();
  }
  return missing;
}

void remove_all_of(const std::vector<fs::path>& folders) {
  std::error_code ignored;
  for (const fs::path& folder : folders) fs::remove(folder, ignored);
}

/// Permissions, quotas and read-only disks show only when something is written.
void probe(const fs::path& folder) {
  const fs::path file = folder / ".probe.part";
  std::error_code ignored;
  try {
    FileWriter(file, FileWriter::Mode::create).write("x");
  } catch (const OutputError&) {
    fs::remove(file, ignored);
    throw;
  }
  fs::remove(file, ignored);
}

void make(const fs::path& folder) {
  const std::vector<fs::path> made = missing_folders(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    remove_all_of(made);
    refuse(folder, error.message());
  }
  try {
    probe(folder);
  } catch (const OutputError& failure) {
    remove_all_of(made);
    refuse(folder, failure.what());
  }
}

std::shared_ptr<const FolderLock> lock_or_refuse(const fs::path& folder) {
  auto lock = FolderLock::try_lock(folder);
  if (!lock) throw InputError(Position{folder.string()}, "another run is at work in this folder");
  return lock;
}

bool is_run_file(const fs::path& file) {
  static constexpr std::array names = {"deck.yaml",         "effective_deck.yaml",
                                       "curve.csv",         "curve.units.json",
                                       "curve.svg",         "deformed.svg",
                                       "log.jsonl",         "run.xdmf",
                                       "summary.json",      "restart.h5",
                                       "overrides.txt",     "report.html",
                                       "eigenvalues.svg",   "modes.svg",
                                       "parameters.xml",    "nox.log",
                                       "model.svg",         "deformed-sliding.svg",
                                       "detail.svg",        "detail-sliding.svg",
                                       "paraview_state.py", "stiffness.txt",
                                       "stiffness.json",    "motion.csv",
                                       "motion.units.json"};
  const fs::path inner = file.parent_path().filename() / file.filename();
  const bool is_of_motion = inner == "motion/end.svg" || inner == "motion/energies.svg";
  if (file.extension() == ".part" || inner == mesh_file || step_of(inner) || is_of_motion) return true;
  for (const char* name : names) {
    if (file.filename() == name) return true;
  }
  return false;
}

void remove_run_files(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!is_run_file(entry.path())) continue;
    fs::remove(entry.path(), error);
    if (error) refuse(folder, fmt::format("cannot remove '{}': {}", entry.path().string(), error.message()));
  }
  // The fields of an earlier run, its motion, and the run of the branch that it left must not be taken for this one's.
  for (const fs::path& part : {folder / fields_folder, folder / "motion", folder / "primary"}) {
    if (!fs::is_directory(part, error)) continue;
    remove_run_files(part);
    fs::remove(part, error);  // stays when it holds anything else
  }
}

}  // namespace

std::shared_ptr<const FolderLock> FolderLock::try_lock(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool is_held = descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  std::shared_ptr<const FolderLock> lock(new FolderLock(descriptor));
  return is_held ? nullptr : lock;
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

RunFolder RunFolder::create(const fs::path& wanted, IfExists policy) {
  if (policy == IfExists::number) return create_numbered(wanted);
  const fs::path folder = without_trailing_separator(wanted);
  if (policy == IfExists::refuse && is_taken(folder)) {
    refuse(folder, "it exists and is not empty; choose another one or allow overwriting");
  }
  if (policy == IfExists::overwrite && is_taken(folder)) lock_or_refuse(folder);
  make(folder);
  auto lock = lock_or_refuse(folder);
  if (policy == IfExists::overwrite) remove_run_files(folder);
  return {folder, std::move(lock)};
}

/// Two runs that start together see the same folder free; one of them gets it.
RunFolder RunFolder::create_numbered(const fs::path& wanted) {
  for (;;) {
    const fs::path folder = first_free(without_trailing_separator(wanted));
    make(folder);
    auto lock = FolderLock::try_lock(folder);
    if (lock && !is_taken(folder)) return {folder, std::move(lock)};
  }
}

RunFolder RunFolder::open(const fs::path& existing) {
  require_run_folder(existing);
  return {existing, lock_or_refuse(existing)};
}

void make_writable(const fs::path& folder) { make(folder); }

void require_run_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError(Position{folder.string()}, "there is no such run folder");
}

fs::path default_run_folder(const fs::path& deck) {
  const fs::path whole = fs::absolute(deck).lexically_normal();
  const fs::path name = whole.stem() == "deck" ? whole.parent_path().filename() : whole.stem();
  return fs::path("runs") / (name.empty() ? fs::path("deck") : name);
}

}  // namespace dda
