#pragma once

#include <filesystem>
#include <string_view>

namespace dda {

/// An open file that takes whole pieces of text and reports every failure.
///
/// A piece reaches the operating system before `write` returns, so it survives a killed process. A piece that
/// cannot be written whole is taken back, and OutputError says which file and why.
class FileWriter {
 public:
  enum class Mode { create, append };

  FileWriter(std::filesystem::path path, Mode mode);
  ~FileWriter();
  FileWriter(FileWriter&& other) noexcept;
  FileWriter& operator=(FileWriter&& other) noexcept;

  void write(std::string_view piece);
  /// Waits until everything is on the disk.
  void sync();
  const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail(int reason) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace dda
