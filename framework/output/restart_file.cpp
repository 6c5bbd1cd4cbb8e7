#include "framework/output/restart_file.hpp"

#include <fmt/format.h>

#include <cstring>
#include <string_view>

#include "framework/errors.hpp"
#include "framework/output/hdf5_file.hpp"
#include "framework/output/run_folder.hpp"

namespace dda {
namespace {

constexpr const char* format_name = "ddapath restart";
constexpr std::int64_t format_version = 3;

/// 64-bit FNV-1a over names, sizes and bytes. Source: Fowler, Noll, Vo, RFC draft-eastlake-fnv.
class Checksum {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 1099511628211u;
  }
  void add(std::string_view text) {
    const std::uint64_t size = text.size();
    add(&size, sizeof size);
    add(text.data(), text.size());
  }
  std::int64_t value() const { return static_cast<std::int64_t>(value_); }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

template <class Value>
void add_arrays(Checksum& sum, const std::map<std::string, std::vector<Value>>& arrays) {
  for (const auto& [name, values] : arrays) {
    sum.add(name);
    sum.add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
  }
}

std::int64_t checksum(const RestartData& data) {
  Checksum sum;
  add_arrays(sum, data.numbers);
  add_arrays(sum, data.integers);
  for (const auto& [name, texts] : data.texts) {
    sum.add(name);
    for (const std::string& text : texts) sum.add(text);
  }
  return sum.value();
}

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
  file.set_attribute("/", "checksum", checksum(data));
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
  RestartData data = data_of(file);
  if (checksum(data) != file.integer_attribute("/", "checksum")) {
    throw Hdf5Error("its checksum does not fit its content");
  }
  return data;
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
