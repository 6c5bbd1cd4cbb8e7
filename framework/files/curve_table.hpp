#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "framework/files/file_writer.hpp"

namespace dda {

/// A column of the curve table: its name in the header, and its unit ("" = none).
struct Column {
  std::string name;
  std::string unit;
};

using TableCell = std::variant<double, std::int64_t, std::string>;

/// One line of CSV, newline included: cells quoted where they must be, numbers in the shortest form that
/// reads back exactly.
std::string csv_line(std::span<const TableCell> row);

/// `curve.csv`: one flushed row per accepted step, so that a run can be watched and killed at any time.
///
/// Plain CSV with one header line; numbers in the shortest form that reads back exactly. The units stand in
/// a side file, `curve.units.json`, {"name": "unit"}, because readers expect nothing but names in the header.
/// Throws OutputError (file, reason) when a row cannot be written; the rows before it stay whole.
class CurveTable {
 public:
  /// Starts an empty table.
  CurveTable(const std::filesystem::path& path, std::vector<Column> columns);
  /// Continues a table after its first `num_rows` rows and drops the others.
  /// Throws InputError when its columns differ or it has fewer rows.
  static CurveTable resume(const std::filesystem::path& path, std::vector<Column> columns,
                           std::size_t num_rows);
  /// Puts a column before column `place` of a table that is not open, with the same cell in every row.
  static void add_column(const std::filesystem::path& path, const Column& column, std::size_t place,
                         const TableCell& cell);

  /// One cell per column, in their order.
  void append(std::span<const TableCell> row);
  std::size_t num_rows() const { return num_rows_; }
  const std::vector<Column>& columns() const { return columns_; }

 private:
  CurveTable(FileWriter file, std::vector<Column> columns, std::size_t num_rows);

  FileWriter file_;
  std::vector<Column> columns_;
  std::size_t num_rows_ = 0;
};

/// A table read back: texts as they stand in the file, by column.
class CsvTable {
 public:
  CsvTable(std::string file, std::vector<std::string> names, std::vector<std::vector<std::string>> columns);

  const std::vector<std::string>& names() const { return names_; }
  std::size_t num_rows() const { return columns_.empty() ? 0 : columns_.front().size(); }
  bool has(std::string_view name) const;
  /// Throw InputError (file, line) for an unknown column or a cell that is not a number.
  const std::vector<std::string>& texts(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;

 private:
  std::size_t index_of(std::string_view name) const;

  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> columns_;
};

/// Reads a CSV file with a header line; quoted cells as in RFC 4180. A last line without its newline is the
/// trace of a killed writer and is left out. Throws InputError (file, line) for rows of unequal length.
CsvTable read_csv(const std::filesystem::path& path);

}  // namespace dda
