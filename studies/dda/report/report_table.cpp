#include <algorithm>

#include "framework/base/errors.hpp"
#include "framework/files/run/base64.hpp"
#include "studies/dda/report/report.hpp"

namespace dda::report {
namespace {

Json column_of(const CsvTable& table, const std::string& name, std::span<const std::size_t> rows) {
  try {
    const std::vector<double> numbers = chosen(table.numbers(name), rows);
    return {{"numbers", base64_of(std::span<const double>(numbers))}};
  } catch (const InputError&) {  // a column of words
    return {{"texts", chosen(table.texts(name), rows)}};
  }
}

}  // namespace

Json columns_of(const CsvTable& table, const Json& units, std::span<const std::size_t> rows) {
  Json columns = Json::array();
  for (const std::string& name : table.names()) {
    Json column{{"name", name}, {"unit", units.is_object() ? units.value(name, "") : ""}};
    column.update(column_of(table, name, rows));
    columns.push_back(std::move(column));
  }
  return {{"rows", rows.size()}, {"all_rows", table.num_rows()}, {"columns", std::move(columns)}};
}

std::vector<std::size_t> kept_rows(std::size_t count, std::size_t most,
                                   const std::vector<std::size_t>& wanted) {
  std::vector<std::size_t> out;
  const std::size_t stride = std::max<std::size_t>(1, (count + most - 1) / std::max<std::size_t>(1, most));
  for (std::size_t row = 0; row < count; row += stride) out.push_back(row);
  if (count > 0) out.push_back(count - 1);
  for (const std::size_t row : wanted)
    if (row < count) out.push_back(row);
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

}  // namespace dda::report
