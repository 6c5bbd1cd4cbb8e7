#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "framework/base/errors.hpp"
#include "framework/files/curve_table.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace {

using Record = std::vector<std::string>;

/// Splits a text into records and cells, one character at a time.
class CsvReader {
 public:
  std::vector<Record> read(const std::string& text) {
    for (const char c : text) take(c);
    return std::move(records_);
  }

 private:
  void take(char c) {
    if (c == '"') {
      // A doubled quote inside a quoted cell is a quote.
      if (!quoted_ && after_quote_) cell_ += '"';
      quoted_ = !quoted_;
      after_quote_ = !quoted_;
      return;
    }
    after_quote_ = false;
    if (quoted_) {
      cell_ += c;
    } else if (c == ',') {
      end_cell();
    } else if (c == '\n') {
      end_record();
    } else if (c != '\r') {
      cell_ += c;
    }
  }

  void end_cell() {
    record_.push_back(std::move(cell_));
    cell_.clear();
  }

  void end_record() {
    end_cell();
    records_.push_back(std::move(record_));
    record_.clear();
  }

  std::vector<Record> records_;
  Record record_;
  std::string cell_;
  bool quoted_ = false;
  bool after_quote_ = false;
};

double number_of(const std::string& text, const Position& where) {
  if (text.empty()) return std::nan("");
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw InputError(where, fmt::format("'{}' is not a number", text));
  }
  return value;
}

}  // namespace

CsvTable::CsvTable(std::string file, std::vector<std::string> names,
                   std::vector<std::vector<std::string>> columns)
    : file_(std::move(file)), names_(std::move(names)), columns_(std::move(columns)) {}

bool CsvTable::has(std::string_view name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

std::size_t CsvTable::index_of(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
  throw InputError(Position{file_, 1},
                   fmt::format("there is no column '{}'; the columns are {}", name, fmt::join(names_, ", ")));
}

const std::vector<std::string>& CsvTable::texts(std::string_view name) const {
  return columns_[index_of(name)];
}

std::vector<double> CsvTable::numbers(std::string_view name) const {
  std::vector<double> values;
  for (const std::string& text : texts(name)) {
    // The header is line 1; a quoted line break in a cell would shift this count.
    values.push_back(number_of(text, Position{file_, static_cast<int>(values.size()) + 2}));
  }
  return values;
}

CsvTable read_csv(const std::filesystem::path& path) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";  // of UTF-8, as spreadsheets write it
  std::string text = read_whole(path);
  if (text.starts_with(mark)) text.erase(0, mark.size());
  const std::vector<Record> records = CsvReader().read(text);
  if (records.empty()) throw InputError(Position{path.string()}, "holds no header line");
  const Record& names = records.front();
  std::vector<std::vector<std::string>> columns(names.size());
  for (std::size_t i = 1; i < records.size(); ++i) {
    if (records[i].size() != names.size()) {
      throw InputError(Position{path.string(), static_cast<int>(i) + 1},
                       fmt::format("{} cells where the header has {}", records[i].size(), names.size()));
    }
    for (std::size_t k = 0; k < names.size(); ++k) columns[k].push_back(records[i][k]);
  }
  return {path.string(), names, std::move(columns)};
}

}  // namespace dda
