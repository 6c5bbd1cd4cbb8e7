#include "framework/files/whole_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <iterator>
#include <random>
#include <system_error>

#include "framework/base/errors.hpp"
#include "framework/files/file_writer.hpp"

namespace dda {
namespace fs = std::filesystem;

namespace {

void write_by_way_of(const fs::path& aside, const fs::path& path, std::string_view text, Flush flush) {
  std::error_code error;
  try {
    FileWriter writer(aside, FileWriter::Mode::create);
    writer.write(text);
    if (flush == Flush::to_disk) writer.sync();
  } catch (const OutputError& failure) {
    fs::remove(aside, error);
    throw;
  }
  fs::rename(aside, path, error);
  if (!error) return;
  const std::string reason = error.message();
  fs::remove(aside, error);
  throw OutputError(fmt::format("cannot write '{}': {}", path.string(), reason));
}

}  // namespace

void write_whole(const fs::path& path, std::string_view text, Flush flush) {
  write_by_way_of(path.string() + ".part", path, text, flush);
}

void write_shared(const fs::path& path, std::string_view text) {
  std::random_device number;
  const fs::path aside = fmt::format("{}.{:08x}{:08x}.part", path.string(), number(), number());
  write_by_way_of(aside, path, text, Flush::to_system);
}

std::ifstream open_for_reading(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError(Position{path.string()}, fs::is_directory(status)
                                                  ? "cannot be read: it is a folder"
                                                  : "cannot be read: it is a device or a pipe");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError(Position{path.string()}, fmt::format("cannot be read: {}", std::strerror(errno)));
  return stream;
}

std::string read_whole(const fs::path& path) {
  std::ifstream stream = open_for_reading(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace dda
