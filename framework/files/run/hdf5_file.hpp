#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dda {

/// HDF5 could not do what was asked; says what, without the file's name. Stays inside framework/files.
class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A column of an array and which of a view it is; see Hdf5File::write_view.
struct ViewedColumn {
  std::string array;
  std::size_t column = 0, as = 0;
};

/// An open HDF5 file: named arrays, texts and attributes; groups on the way to a name are made as needed.
///
/// Arrays have `width` columns; width 1 makes them one-dimensional. Every method throws Hdf5Error.
class Hdf5File {
 public:
  /// A file of the disk, for reading; like `from_bytes` only if its checksum fits (seal.hpp). Throws
  /// InputError as well, when it is no file that can be read.
  static Hdf5File open(const std::filesystem::path& path);
  /// A file in memory: empty, or from the bytes of one.
  static Hdf5File in_memory();
  static Hdf5File from_bytes(const std::string& bytes);
  ~Hdf5File();
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&&) = delete;

  void write(const std::string& name, std::span<const double> values, std::size_t width = 1);
  void write(const std::string& name, std::span<const std::int64_t> values, std::size_t width = 1);
  void write(const std::string& name, const std::vector<std::string>& texts);
  /// An array of numbers of `width` columns, each a column of another array of this file or 0: no copy, whatever reads it reads
  /// those (a virtual dataset, HDF5 1.10). They have as many rows, at least one.
  void write_view(const std::string& name, std::size_t width, const std::vector<ViewedColumn>& columns);
  void make_group(const std::string& name);

  std::vector<double> numbers(const std::string& name) const;
  std::vector<std::int64_t> integers(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  /// Length of the first dimension.
  std::size_t num_rows(const std::string& name) const;
  /// Members of a group by name, in alphabetical order; empty when there is no such group.
  std::vector<std::string> members(const std::string& group) const;
  bool has(const std::string& name) const;

  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void set_attribute(const std::string& object, const std::string& name, const std::string& value);
  double number_attribute(const std::string& object, const std::string& name) const;
  std::int64_t integer_attribute(const std::string& object, const std::string& name) const;
  std::string text_attribute(const std::string& object, const std::string& name) const;
  bool has_attribute(const std::string& object, const std::string& name) const;
  /// Names in alphabetical order.
  std::vector<std::string> attributes(const std::string& object) const;

  /// The whole file as bytes, sealed with its checksum.
  std::string bytes() const;

 private:
  explicit Hdf5File(std::int64_t id) : id_(id) {}
  std::int64_t id_ = -1;
};

}  // namespace dda
