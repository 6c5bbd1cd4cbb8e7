#include "framework/files/file_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "framework/base/errors.hpp"

namespace dda {
namespace {

int flags_of(FileWriter::Mode mode) {
  const int common = O_WRONLY | O_CREAT | O_CLOEXEC | O_APPEND;
  return mode == FileWriter::Mode::create ? common | O_TRUNC : common;
}

/// Writes everything; the number of the error, or 0.
int write_all(int descriptor, std::string_view piece) {
  while (!piece.empty()) {
    const ssize_t written = ::write(descriptor, piece.data(), piece.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return ENOSPC;
    piece.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

FileWriter::FileWriter(std::filesystem::path path, Mode mode) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), flags_of(mode), 0644);
  if (descriptor_ < 0) fail(errno);
}

FileWriter::~FileWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileWriter& FileWriter::operator=(FileWriter&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

void FileWriter::write(std::string_view piece) {
  const off_t before = ::lseek(descriptor_, 0, SEEK_END);
  const int reason = write_all(descriptor_, piece);
  if (reason == 0) return;
  // A part of the piece may be in the file; a reader must not take it for a whole one.
  [[maybe_unused]] const int cut = ::ftruncate(descriptor_, before);
  fail(reason);
}

void FileWriter::sync() {
  // Devices and pipes cannot be synchronised (EINVAL) and need not be.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(errno);
}

void FileWriter::fail(int reason) const {
  throw OutputError(fmt::format("cannot write '{}': {}", path_.string(), std::strerror(reason)));
}

}  // namespace dda
