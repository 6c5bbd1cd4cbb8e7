#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

namespace dda {

/// What to do when the wanted run folder already holds something.
enum class IfExists {
  number,    ///< take the next free of NAME-2, NAME-3, ...
  refuse,    ///< throw OutputError
  overwrite  ///< remove the files an earlier run left there; anything else in the folder is kept
};

/// Keeps processes apart that write in one folder: the system's lock on the folder itself, which ends with
/// the process however that ends. Where a file system has no locks there is none.
class FolderLock {
 public:
  /// Null when another one holds it.
  static std::shared_ptr<const FolderLock> try_lock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// The folder that holds everything one run writes; it exists and is writable once constructed, and no other
/// process writes in it while this lives.
///
/// Throws OutputError, with the folder and the reason, when it cannot be made; then nothing is left behind.
/// Throws InputError when another run is at work there.
class RunFolder {
 public:
  static RunFolder create(const std::filesystem::path& wanted, IfExists policy);
  /// The folder of an earlier run, to be continued. Throws InputError when there is none.
  static RunFolder open(const std::filesystem::path& existing);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(std::string_view name) const { return path_ / name; }

 private:
  static RunFolder create_numbered(const std::filesystem::path& wanted);
  RunFolder(std::filesystem::path path, std::shared_ptr<const FolderLock> lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}
  std::filesystem::path path_;
  std::shared_ptr<const FolderLock> lock_;
};

/// Makes a folder that several processes may write in. Throws OutputError, with the folder and the reason, when it cannot be
/// made or written in; then nothing is left behind.
void make_writable(const std::filesystem::path& folder);

/// Throws InputError when there is no folder of a run, for commands that only read.
void require_run_folder(const std::filesystem::path& folder);

/// Where a deck's results go unless told otherwise: runs/NAME, NAME being the deck's own name, or that of its
/// folder when the file is called "deck".
std::filesystem::path default_run_folder(const std::filesystem::path& deck);

}  // namespace dda
