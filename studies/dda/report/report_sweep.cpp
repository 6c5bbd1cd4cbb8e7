#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "framework/base/errors.hpp"
#include "framework/files/run/base64.hpp"
#include "framework/files/run/run_folder.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/record/column_names.hpp"
#include "studies/dda/report/report.hpp"

namespace dda::report {
namespace fs = std::filesystem;
namespace {

/// A relative path as a link; "./" in front keeps a folder's name from being taken for a protocol.
std::string link_to(const fs::path& target, const fs::path& page) {
  const fs::path from = fs::absolute(page).parent_path().lexically_normal();
  const std::string path = fs::absolute(target).lexically_normal().lexically_relative(from).generic_string();
  std::string out = "./";
  for (const char c : path) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) ||
                       std::string_view("/-_.~").find(c) != std::string_view::npos;
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

bool is_axis(const std::string& name, const std::string& unit, const std::string& length) {
  return name == column::load || name == column::load_factor || name == column::dissipated_energy ||
         unit == length;
}

/// Load, energy and displacements of a case, in single precision.
Json curve_of(const fs::path& run, std::size_t most_rows, Json& notices) {
  const CsvTable table = read_csv(run / "curve.csv");
  const Json units = read_json(run / "curve.units.json", notices);
  const Json summary = read_json(run / "summary.json", notices);
  std::string length = "mm";
  if (summary.is_object() && summary.contains("units")) length = summary["units"].value("length", length);
  const std::vector<std::size_t> rows = kept_rows(table.num_rows(), most_rows, {});
  Json columns = Json::array();
  for (const std::string& name : table.names()) {
    const std::string unit = units.is_object() ? units.value(name, "") : "";
    if (!is_axis(name, unit, length)) continue;
    const std::vector<double> all = table.numbers(name);
    std::vector<float> values;
    for (const std::size_t row : rows) values.push_back(static_cast<float>(all[row]));
    columns.push_back(
        {{"name", name}, {"unit", unit}, {"singles", base64_of(std::span<const float>(values))}});
  }
  return columns;
}

/// What the page says of a case beside its row of the table.
Json case_of(const Json& entry, const fs::path& folder, const fs::path& page, std::size_t most_rows) {
  Json out = entry;
  const fs::path run = folder / entry.value("folder", "");
  Json notices = Json::array();
  if (fs::is_directory(run)) {
    const fs::path report = run / "report.html";
    out["link"] = link_to(fs::exists(report) ? report : run / "", page);
  }
  try {
    if (fs::exists(run / "curve.csv")) out["curve"] = curve_of(run, most_rows, notices);
  } catch (const InputError& error) {
    notices.push_back(error.what());
  }
  if (!notices.empty()) out["notices"] = notices;
  return out;
}

std::optional<CsvTable> table_of(const fs::path& folder) {
  if (!fs::exists(folder / "sweep.csv")) return {};
  return read_csv(folder / "sweep.csv");
}

/// The cases as sweep.json has them, or, where it is lost, as the table's rows name them.
Json entries_of(const Json& sweep, const std::optional<CsvTable>& table) {
  if (sweep.is_object() && sweep.contains("cases") && sweep["cases"].is_array()) return sweep["cases"];
  Json out = Json::array();
  if (!table || !table->has("folder")) return out;
  for (const std::string& folder : table->texts("folder")) out.push_back({{"folder", folder}});
  return out;
}

}  // namespace

bool is_sweep(const fs::path& folder) {
  return fs::exists(folder / "sweep.json") || fs::exists(folder / "sweep.csv");
}

std::vector<fs::path> runs_of_sweep(const fs::path& folder) {
  Json notices = Json::array();
  std::vector<fs::path> out;
  for (const Json& entry : entries_of(read_json(folder / "sweep.json", notices), table_of(folder)))
    if (const fs::path run = folder / entry.value("folder", ""); is_run(run)) out.push_back(run);
  return out;
}

Json data_of_sweep(const fs::path& folder, const fs::path& page, const Limits& limits) {
  const fs::path whole = (fs::absolute(folder) / "").lexically_normal();
  Json notices = Json::array();
  const Json sweep = read_json(folder / "sweep.json", notices);
  const std::string name = whole.parent_path().filename().string();
  Json data{{"kind", "sweep"}, {"name", name}, {"generator", to_texts(provenance())}};
  const std::string title = sweep.is_object() ? sweep.value("title", "") : "";
  data["title"] = title.empty() ? name : title;
  data["deck"] = read_text(folder / "sweep.yaml", limits.text);
  const std::optional<CsvTable> table = table_of(folder);
  if (table)
    data["table"] = columns_of(*table, read_json(folder / "sweep.units.json", notices),
                               kept_rows(table->num_rows(), table->num_rows(), {}));
  const Json entries = entries_of(sweep, table);
  constexpr std::size_t usual_columns = 6;
  const std::size_t most_rows =
      std::max<std::size_t>(20, limits.cells / usual_columns / std::max<std::size_t>(1, entries.size()));
  data["cases"] = Json::array();
  for (const Json& entry : entries) data["cases"].push_back(case_of(entry, folder, page, most_rows));
  for (const char* key : {"units", "overrides"})
    if (sweep.is_object() && sweep.contains(key)) data[key] = sweep[key];
  data["notices"] = notices;
  return data;
}

}  // namespace dda::report
