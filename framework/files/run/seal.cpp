#include "framework/files/run/seal.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <istream>
#include <vector>

#include "framework/files/run/hdf5_file.hpp"

namespace dda {
namespace {

constexpr std::string_view name = "ddapath checksum ";
constexpr std::size_t seal_size = name.size() + 8 + 1;

uLong extended(uLong checksum, std::string_view bytes) {
  return crc32_z(checksum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

std::string seal(uLong checksum) { return fmt::format("{}{:08x}\n", name, checksum); }

/// Of the next bytes of a stream.
uLong sum_of(std::istream& stream, std::size_t size) {
  std::vector<char> buffer(std::size_t{1} << 16);
  uLong checksum = 0;
  while (size > 0 && stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(std::min(size, buffer.size())));
    const auto count = static_cast<std::size_t>(stream.gcount());
    checksum = extended(checksum, {buffer.data(), count});
    size -= count;
  }
  return checksum;
}

}  // namespace

std::string checksum_of(std::string_view bytes) { return fmt::format("{:08x}", extended(0, bytes)); }

std::string seal_of(std::string_view bytes) { return seal(extended(0, bytes)); }

std::size_t size_before_seal(std::istream& stream) {
  stream.seekg(0, std::ios::end);
  const auto all = static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0));
  const std::size_t size = std::max(all, seal_size) - seal_size;
  stream.seekg(0);
  const uLong checksum = sum_of(stream, size);
  std::string found(std::min(all, seal_size), '\0');
  stream.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (!found.starts_with(name)) throw Hdf5Error("it is cut short, of another kind or by another version");
  if (found != seal(checksum)) throw Hdf5Error("its checksum does not fit its content");
  stream.seekg(0);
  return size;
}

}  // namespace dda
