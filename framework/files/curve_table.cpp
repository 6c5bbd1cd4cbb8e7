#include "framework/files/curve_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/base/errors.hpp"
#include "framework/files/number_text.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace fs = std::filesystem;
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

std::string text_of(const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return shortest(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return std::to_string(*integer);
  return quoted(std::get<std::string>(cell));
}

std::string header_of(const std::vector<Column>& columns) {
  std::string line;
  for (const Column& column : columns) line += (line.empty() ? "" : ",") + quoted(column.name);
  return line + '\n';
}

void write_units(const fs::path& table, const std::vector<Column>& columns) {
  nlohmann::ordered_json units = nlohmann::ordered_json::object();
  for (const Column& column : columns) units[column.name] = column.unit;
  write_whole(fs::path(table).replace_extension(".units.json"), units.dump(2) + '\n', Flush::to_system);
}

/// Where the record that starts at `begin` ends, newline included; npos when the newline is missing.
std::size_t end_of_record(const std::string& text, std::size_t begin) {
  bool inside_quotes = false;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (text[i] == '"') inside_quotes = !inside_quotes;
    if (text[i] == '\n' && !inside_quotes) return i + 1;
  }
  return std::string::npos;
}

}  // namespace

std::string csv_line(std::span<const TableCell> row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) line += (i == 0 ? "" : ",") + text_of(row[i]);
  return line + '\n';
}

CurveTable::CurveTable(const fs::path& path, std::vector<Column> columns)
    : file_(path, FileWriter::Mode::create), columns_(std::move(columns)) {
  file_.write(header_of(columns_));
  write_units(path, columns_);
}

CurveTable::CurveTable(FileWriter file, std::vector<Column> columns, std::size_t num_rows)
    : file_(std::move(file)), columns_(std::move(columns)), num_rows_(num_rows) {}

CurveTable CurveTable::resume(const fs::path& path, std::vector<Column> columns, std::size_t num_rows) {
  const std::string text = read_whole(path);
  const std::string header = header_of(columns);
  if (text.compare(0, header.size(), header) != 0) {
    throw InputError(Position{path.string(), 1}, "its columns are not those of this run");
  }
  std::size_t kept = header.size();
  for (std::size_t row = 0; row < num_rows; ++row) {
    kept = end_of_record(text, kept);
    if (kept == std::string::npos) {
      throw InputError(Position{path.string()}, fmt::format("has {} rows, {} are needed", row, num_rows));
    }
  }
  if (kept < text.size()) write_whole(path, std::string_view(text).substr(0, kept));
  return {FileWriter(path, FileWriter::Mode::append), std::move(columns), num_rows};
}

void CurveTable::add_column(const fs::path& path, const Column& column, std::size_t place,
                            const TableCell& cell) {
  const CsvTable table = read_csv(path);
  const fs::path units_file = fs::path(path).replace_extension(".units.json");
  const auto known = nlohmann::json::parse(read_whole(units_file));
  std::vector<Column> columns;
  for (const std::string& name : table.names()) columns.push_back({name, known.value(name, "")});
  columns.insert(columns.begin() + static_cast<std::ptrdiff_t>(place), column);
  std::string text = header_of(columns);
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    std::vector<TableCell> cells;
    for (const Column& each : columns)
      cells.push_back(each.name == column.name ? cell : table.texts(each.name)[row]);
    text += csv_line(cells);
  }
  write_units(path, columns);  // a name too many harms nobody where a kill comes between the two
  write_whole(path, text, Flush::to_system);
}

void CurveTable::append(std::span<const TableCell> row) {
  if (row.size() != columns_.size()) {
    throw std::invalid_argument(fmt::format("{} cells for {} columns", row.size(), columns_.size()));
  }
  file_.write(csv_line(row));
  ++num_rows_;
}

}  // namespace dda
