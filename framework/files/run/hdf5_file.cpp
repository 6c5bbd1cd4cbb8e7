#include "framework/files/run/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <array>
#include <atomic>
#include <fstream>
#include <sstream>
#include <utility>

#include "framework/files/run/seal.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace {

/// HDF5 prints its error stack to the terminal unless told not to.
void silence() {
  static const bool done = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  if (!done) throw Hdf5Error("HDF5 cannot be started");
}

/// The innermost entry of the error stack says what the operating system answered.
std::string last_reason() {
  std::string reason;
  const auto keep = [](unsigned, const H5E_error2_t* entry, void* result) -> herr_t {
    *static_cast<std::string*>(result) = entry->desc != nullptr ? entry->desc : "";
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep, &reason);
  return reason.empty() ? "unknown HDF5 error" : reason;
}

/// Passes results through and turns negative ones into exceptions.
template <class Result>
Result checked(Result result, const std::string& what) {
  if (result < 0) throw Hdf5Error(fmt::format("{}: {}", what, last_reason()));
  return result;
}

/// Closes an HDF5 identifier at the end of its scope.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& what) : id_(checked(id, what)), close_(close) {}
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

Handle file_access() {
  silence();
  const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fclose_degree(list, H5F_CLOSE_STRONG);
  return Handle(list, H5Pclose, "file access");
}

Handle memory_access() {
  silence();
  constexpr std::size_t growth = 1 << 16;
  const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fclose_degree(list, H5F_CLOSE_STRONG);
  H5Pset_fapl_core(list, growth, 0);
  return Handle(list, H5Pclose, "file access");
}

Handle making_groups() {
  const hid_t list = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(list, 1);
  return Handle(list, H5Pclose, "link creation");
}

Handle text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return Handle(type, H5Tclose, "text type");
}

Handle space_of(std::size_t size, std::size_t width) {
  const std::array<hsize_t, 2> extent = {size / width, width};
  return Handle(H5Screate_simple(width == 1 ? 1 : 2, extent.data(), nullptr), H5Sclose, "array size");
}

/// HDF5 clears both buffers in which it converts texts; by default each has 1 MiB, whatever is to be
/// converted.
Handle transfer() {
  constexpr std::size_t buffer = 1 << 12;
  const hid_t list = H5Pcreate(H5P_DATASET_XFER);
  H5Pset_buffer(list, buffer, nullptr, nullptr);
  return Handle(list, H5Pclose, "transfer");
}

/// A type for storage and for memory; the same layout in both, so values pass bit for bit.
void write_array(hid_t file, const std::string& name, hid_t type, std::pair<const void*, hid_t> values) {
  const Handle links = making_groups();
  const Handle set(H5Dcreate2(file, name.c_str(), type, values.second, links, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose, name);
  if (H5Sget_simple_extent_npoints(values.second) == 0) return;
  checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, transfer(), values.first), name);
}

Handle open_array(hid_t file, const std::string& name) {
  return Handle(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name);
}

/// Of an array's numbers those of one column.
void select_column(const Handle& space, std::size_t rows, std::size_t column) {
  const std::array<hsize_t, 2> start = {0, column}, count = {rows, 1};
  checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), "column");
}

std::size_t size_of(hid_t set, const std::string& name) {
  const Handle space(H5Dget_space(set), H5Sclose, name);
  return static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), name));
}

template <class Value>
std::vector<Value> read_array(hid_t file, const std::string& name, hid_t type) {
  const Handle set = open_array(file, name);
  std::vector<Value> values(size_of(set, name));
  if (!values.empty()) checked(H5Dread(set, type, H5S_ALL, H5S_ALL, transfer(), values.data()), name);
  return values;
}

void write_attribute(hid_t file, std::pair<const char*, const char*> where, hid_t type, const void* value) {
  const auto [object, name] = where;
  if (H5Aexists_by_name(file, object, name, H5P_DEFAULT) > 0) {
    checked(H5Adelete_by_name(file, object, name, H5P_DEFAULT), name);
  }
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute(
      H5Acreate_by_name(file, object, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      name);
  checked(H5Awrite(attribute, type, value), name);
}

void read_attribute(hid_t file, std::pair<const char*, const char*> where, hid_t type, void* value) {
  const Handle attribute(H5Aopen_by_name(file, where.first, where.second, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         where.second);
  checked(H5Aread(attribute, type, value), where.second);
}

/// HDF5 takes two open files in memory of the same name for one file.
std::string unique_name() {
  static std::atomic<int> count = 0;
  return fmt::format("memory-{}", ++count);
}

}  // namespace

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
  std::ifstream stream = open_for_reading(path);
  size_before_seal(stream);
  const Handle properties = file_access();
  return Hdf5File(checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, properties), "open"));
}

Hdf5File Hdf5File::in_memory() {
  const Handle properties = memory_access();
  return Hdf5File(
      checked(H5Fcreate(unique_name().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, properties), "create"));
}

Hdf5File Hdf5File::from_bytes(const std::string& bytes) {
  std::istringstream stream(bytes);
  const std::size_t size = size_before_seal(stream);
  const Handle properties = memory_access();
  // HDF5 copies the bytes; its interface has no const.
  checked(H5Pset_file_image(properties, const_cast<char*>(bytes.data()), size), "image");
  return Hdf5File(checked(H5Fopen(unique_name().c_str(), H5F_ACC_RDONLY, properties), "open"));
}

Hdf5File::~Hdf5File() {
  if (id_ >= 0) H5Fclose(id_);
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept : id_(std::exchange(other.id_, -1)) {}

void Hdf5File::write(const std::string& name, std::span<const double> values, std::size_t width) {
  write_array(id_, name, H5T_NATIVE_DOUBLE, {values.data(), space_of(values.size(), width)});
}

void Hdf5File::write(const std::string& name, std::span<const std::int64_t> values, std::size_t width) {
  write_array(id_, name, H5T_NATIVE_INT64, {values.data(), space_of(values.size(), width)});
}

void Hdf5File::write(const std::string& name, const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  write_array(id_, name, text_type(), {pointers.data(), space_of(texts.size(), 1)});
}

void Hdf5File::write_view(const std::string& name, std::size_t width,
                          const std::vector<ViewedColumn>& columns) {
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  const std::size_t rows = num_rows(columns.at(0).array);
  for (const auto& [array, column, as] : columns) {
    const Handle set = open_array(id_, array);
    const Handle from(H5Dget_space(set), H5Sclose, array), to = space_of(rows * width, width);
    select_column(from, rows, column);
    select_column(to, rows, as);
    checked(H5Pset_virtual(properties, to, ".", array.c_str(), from), name);
  }
  const Handle links = making_groups(), space = space_of(rows * width, width);
  const Handle set(H5Dcreate2(id_, name.c_str(), H5T_NATIVE_DOUBLE, space, links, properties, H5P_DEFAULT),
                   H5Dclose, name);
}

void Hdf5File::make_group(const std::string& name) {
  const Handle links = making_groups();
  const Handle group(H5Gcreate2(id_, name.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name);
}

std::vector<double> Hdf5File::numbers(const std::string& name) const {
  return read_array<double>(id_, name, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Hdf5File::integers(const std::string& name) const {
  return read_array<std::int64_t>(id_, name, H5T_NATIVE_INT64);
}

std::vector<std::string> Hdf5File::texts(const std::string& name) const {
  const Handle type = text_type();
  const auto pointers = read_array<char*>(id_, name, type);
  std::vector<std::string> result;
  for (char* pointer : pointers) {
    result.emplace_back(pointer != nullptr ? pointer : "");
    H5free_memory(pointer);
  }
  return result;
}

std::size_t Hdf5File::num_rows(const std::string& name) const {
  const Handle set = open_array(id_, name);
  const Handle space(H5Dget_space(set), H5Sclose, name);
  std::array<hsize_t, H5S_MAX_RANK> extent{};
  checked(H5Sget_simple_extent_dims(space, extent.data(), nullptr), name);
  return extent[0];
}

std::vector<std::string> Hdf5File::members(const std::string& group) const {
  std::vector<std::string> names;
  if (!has(group)) return names;
  const Handle opened(H5Gopen2(id_, group.c_str(), H5P_DEFAULT), H5Gclose, group);
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* result) -> herr_t {
    static_cast<std::vector<std::string>*>(result)->emplace_back(name);
    return 0;
  };
  checked(H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep, &names), group);
  return names;
}

bool Hdf5File::has(const std::string& name) const {
  // H5Lexists asks for one link only, so every part of the name is asked in turn.
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (H5Lexists(id_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(id_, {object.c_str(), name.c_str()}, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  write_attribute(id_, {object.c_str(), name.c_str()}, H5T_NATIVE_INT64, &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& value) {
  const char* text = value.c_str();
  write_attribute(id_, {object.c_str(), name.c_str()}, text_type(), &text);
}

double Hdf5File::number_attribute(const std::string& object, const std::string& name) const {
  double value = 0;
  read_attribute(id_, {object.c_str(), name.c_str()}, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::int64_t Hdf5File::integer_attribute(const std::string& object, const std::string& name) const {
  std::int64_t value = 0;
  read_attribute(id_, {object.c_str(), name.c_str()}, H5T_NATIVE_INT64, &value);
  return value;
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  char* text = nullptr;
  read_attribute(id_, {object.c_str(), name.c_str()}, text_type(), &text);
  std::string result = text != nullptr ? text : "";
  H5free_memory(text);
  return result;
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::attributes(const std::string& object) const {
  std::vector<std::string> names;
  const auto keep = [](hid_t, const char* name, const H5A_info_t*, void* result) -> herr_t {
    static_cast<std::vector<std::string>*>(result)->emplace_back(name);
    return 0;
  };
  hsize_t from = 0;
  checked(
      H5Aiterate_by_name(id_, object.c_str(), H5_INDEX_NAME, H5_ITER_INC, &from, keep, &names, H5P_DEFAULT),
      object);
  return names;
}

std::string Hdf5File::bytes() const {
  checked(H5Fflush(id_, H5F_SCOPE_GLOBAL), "flush");
  std::string result(static_cast<std::size_t>(checked(H5Fget_file_image(id_, nullptr, 0), "image")), '\0');
  checked(H5Fget_file_image(id_, result.data(), result.size()), "image");
  return result + seal_of(result);
}

}  // namespace dda
