#include "framework/files/run/restart_file.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "framework/base/errors.hpp"
#include "framework/files/run/hdf5_file.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace {

constexpr const char* format_name = "ddapath restart";
constexpr std::int64_t format_version = 7;

template <class Value>
void write_group(Hdf5File& file, const std::string& group,
                 const std::map<std::string, std::vector<Value>>& arrays) {
  file.make_group(group);
  for (const auto& [name, values] : arrays) file.write(group + "/" + name, values);
}

std::string bytes_of(const RestartData& data) {
  Hdf5File file = Hdf5File::in_memory();
  write_group(file, "/numbers", data.numbers);
  write_group(file, "/integers", data.integers);
  write_group(file, "/texts", data.texts);
  file.set_attribute("/", "format", std::string(format_name));
  file.set_attribute("/", "format_version", format_version);
  return file.bytes();
}

RestartData data_of(const Hdf5File& file) {
  RestartData data;
  for (const auto& name : file.members("/numbers")) data.numbers[name] = file.numbers("/numbers/" + name);
  for (const auto& name : file.members("/integers")) data.integers[name] = file.integers("/integers/" + name);
  for (const auto& name : file.members("/texts")) data.texts[name] = file.texts("/texts/" + name);
  return data;
}

RestartData checked_data(const Hdf5File& file) {
  if (!file.has_attribute("/", "format") || file.text_attribute("/", "format") != format_name) {
    throw Hdf5Error("it is an HDF5 file of another kind");
  }
  if (const auto version = file.integer_attribute("/", "format_version"); version != format_version) {
    throw Hdf5Error(fmt::format("its format version is {}, this program reads {}", version, format_version));
  }
  return data_of(file);
}

}  // namespace

void write_restart(const std::filesystem::path& path, const RestartData& data, Flush flush) {
  write_whole(path, bytes_of(data), flush);
}

RestartData read_restart(const std::filesystem::path& path) {
  const std::string bytes = read_whole(path);
  try {
    return checked_data(Hdf5File::from_bytes(bytes));
  } catch (const Hdf5Error& error) {
    throw InputError(Position{path.string()}, fmt::format("is not a whole restart file: {}", error.what()));
  }
}

}  // namespace dda
