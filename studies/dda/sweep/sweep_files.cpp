#include "studies/dda/sweep/sweep_files.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "framework/deck/changes/settings.hpp"
#include "framework/deck/writing/node_json.hpp"
#include "framework/files/curve_table.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/record/column_names.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

using Scalars = std::vector<std::pair<std::string, TableCell>>;

/// Said of every case by columns of the sweep's own.
constexpr std::array own_columns = {"status", "exit_code", "reason"};

TableCell cell_of(const Json& json) {
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_boolean()) return json.get<bool>() ? "true" : "false";
  return json.is_string() ? json.get<std::string>() : "";
}

void flatten(const Json& json, const std::string& name, Scalars& out) {
  if (json.is_object())
    for (const auto& [key, value] : json.items()) flatten(value, name.empty() ? key : name + "." + key, out);
  else if (!json.is_array())
    out.emplace_back(name, cell_of(json));
}

TableCell cell_of(const Node& node) {
  const Json json = to_json(node);
  return json.is_structured() ? to_flow_yaml(node) : cell_of(json);
}

/// The unit of a scalar of summary.json, from those of the curve's columns.
std::string unit_of(const std::string& name, const Json& units) {
  const auto of_column = [&](const std::string& column) {
    return units.is_object() ? units.value(column, "") : std::string();
  };
  if (name.starts_with("timings.")) return "s";
  if (name == "peak_memory_mib") return "MiB";
  if (name == "jump_energy") return of_column(column::external_work);
  if (name.starts_with("interfaces.") && name.ends_with(".dissipated_energy"))
    return of_column(column::dissipated_energy);
  constexpr std::string_view gauges = "peak.gauges.";
  if (name.starts_with(gauges)) return of_column(name.substr(gauges.size()));
  return of_column(name == "peak.load" ? column::load : name);
}

/// The rows' scalars and the union of their names, in the order in which they first occur.
class TableBuilder {
 public:
  TableBuilder(const Sweep& sweep, const std::vector<CaseState>& states) : sweep_(sweep), states_(states) {
    for (const SweptKey& key : sweep.keys()) taken_.push_back(key.name);
    std::ranges::copy(own_columns, std::back_inserter(taken_));
    for (const DerivedColumn& column : sweep.derived) taken_.push_back(column.name);
    for (std::size_t i = 0; i < states.size(); ++i) collect(i);
  }

  SweepTable build() const {
    std::vector<TableCell> header{"case", "folder"};
    for (const std::string& name : taken_) header.emplace_back(name);
    for (const std::string& name : names_) header.emplace_back(name);
    SweepTable out{csv_line(header), Json::object()};
    for (std::size_t i = 0; i < states_.size(); ++i) out.csv += csv_line(row(i));
    for (const TableCell& cell : header) out.units[std::get<std::string>(cell)] = "";
    for (std::size_t k = 0; k < sweep_.key_units.size(); ++k) out.units[taken_[k]] = sweep_.key_units[k];
    for (const auto& [name, unit] : units_) out.units[name] = unit;
    return out;
  }

 private:
  void collect(std::size_t i) {
    rows_.emplace_back();
    if (!states_[i].summary.is_object()) return;
    Scalars scalars;
    flatten(states_[i].summary, "", scalars);
    for (auto& [name, cell] : scalars) {
      if (std::ranges::find(taken_, name) != taken_.end()) continue;
      note_unit(name, unit_of(name, states_[i].curve_units));
      rows_.back().emplace(name, std::move(cell));
    }
  }

  void note_unit(const std::string& name, const std::string& unit) {
    const auto [known, is_new] = units_.emplace(name, unit);
    if (is_new) names_.push_back(name);
    if (known->second != unit) known->second = "";
  }

  std::vector<TableCell> row(std::size_t i) const {
    const CaseState& state = states_[i];
    std::vector<TableCell> out{static_cast<std::int64_t>(i + 1), case_folder(sweep_, i).string()};
    for (const Node& value : sweep_.cases[i].values) out.push_back(cell_of(value));
    out.emplace_back(name_of(state.status));
    out.push_back(state.exit_code ? TableCell(std::int64_t{*state.exit_code}) : TableCell(""));
    out.emplace_back(state.reason);
    for (const auto& value : values_of(sweep_.derived, sweep_.cases[i].known, state.summary))
      out.push_back(value ? TableCell(*value) : TableCell(""));
    for (const std::string& name : names_) {
      const auto found = rows_[i].find(name);
      out.push_back(found == rows_[i].end() ? TableCell("") : found->second);
    }
    return out;
  }

  const Sweep& sweep_;
  const std::vector<CaseState>& states_;
  std::vector<std::string> taken_, names_;
  std::map<std::string, std::string> units_;
  std::vector<std::map<std::string, TableCell>> rows_;
};

Json axes_of(const Sweep& sweep) {
  Json out = Json::array();
  for (const Axis& axis : sweep.axes) {
    Json keys = Json::array(), values = Json::object();
    for (const SweptKey& key : axis.keys) {
      keys.push_back(key.name);
      values[key.name] = to_json(Node::sequence(key.values));
    }
    out.push_back({{"keys", keys}, {"values", values}});
  }
  return out;
}

Json case_json(const Sweep& sweep, std::size_t i, const CaseState& state) {
  const SweepCase& one = sweep.cases[i];
  const std::vector<SweptKey> keys = sweep.keys();
  Json out{{"number", i + 1}, {"folder", case_folder(sweep, i).string()}, {"deck", one.deck.string()}};
  out["settings"] = Json::object();
  for (std::size_t k = 0; k < keys.size(); ++k) out["settings"][keys[k].name] = to_json(one.values[k]);
  out["overrides"] = one.overrides;
  out["status"] = name_of(state.status);
  out["reason"] = state.reason;
  out["exit_code"] = state.exit_code ? Json(*state.exit_code) : Json();
  return out;
}

}  // namespace

Json sweep_json(const Sweep& sweep, const std::string& name, const std::vector<CaseState>& states) {
  Json out{{"name", name}, {"title", sweep.title}};
  out["units"] = {{"length", sweep.units.length}, {"force", sweep.units.force}};
  out["file"] = fs::absolute(sweep.file).lexically_normal().string();
  out["overrides"] = sweep.overrides;
  out["version"] = provenance().version;
  out["axes"] = axes_of(sweep);
  out["cases"] = Json::array();
  for (std::size_t i = 0; i < states.size(); ++i) out["cases"].push_back(case_json(sweep, i, states[i]));
  return out;
}

SweepTable sweep_table(const Sweep& sweep, const std::vector<CaseState>& states) {
  return TableBuilder(sweep, states).build();
}

void write_sweep_files(const Sweep& sweep, const fs::path& folder, const std::vector<CaseState>& states) {
  const std::string name = fs::absolute(folder / "").lexically_normal().parent_path().filename().string();
  const SweepTable table = sweep_table(sweep, states);
  write_shared(folder / "sweep.json", sweep_json(sweep, name, states).dump(2) + "\n");
  write_shared(folder / "sweep.csv", table.csv);
  write_shared(folder / "sweep.units.json", table.units.dump(2) + "\n");
}

}  // namespace dda
