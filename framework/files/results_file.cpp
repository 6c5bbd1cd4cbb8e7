#include "framework/files/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "framework/base/errors.hpp"
#include "framework/files/hdf5_file.hpp"
#include "framework/files/run_folder.hpp"
#include "framework/files/xdmf.hpp"

namespace dda {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t xdmf_polygon = 3;  // XDMF 2.2: type number of a polygon in a Mixed topology

std::vector<double> in_space(const std::vector<Vec2>& points) {
  std::vector<double> values;
  values.reserve(3 * points.size());
  for (const Vec2& point : points) values.insert(values.end(), {point.x(), point.y(), 0.0});
  return values;
}

void write_blocks(Hdf5File& file, const ResultsMesh& mesh) {
  std::vector<Vec2> vertices;
  std::vector<std::int64_t> mixed, offsets = {0};
  for (const auto& outline : mesh.blocks) {
    mixed.insert(mixed.end(), {xdmf_polygon, static_cast<std::int64_t>(outline.size())});
    for (const Vec2& vertex : outline) {
      mixed.push_back(static_cast<std::int64_t>(vertices.size()));
      vertices.push_back(vertex);
    }
    offsets.push_back(static_cast<std::int64_t>(vertices.size()));
  }
  file.write("/mesh/vertices", in_space(vertices), 3);
  file.write("/mesh/offsets", offsets);
  file.write("/mesh/mixed", mixed);
}

void write_segments(Hdf5File& file, const ResultsMesh& mesh) {
  std::vector<Vec2> ends;
  std::vector<std::int64_t> pairs;
  for (const auto& [start, end] : mesh.segments) {
    ends.insert(ends.end(), {start, end});
    pairs.insert(pairs.end(),
                 {static_cast<std::int64_t>(ends.size()) - 2, static_cast<std::int64_t>(ends.size()) - 1});
  }
  file.write("/mesh/segment_ends", in_space(ends), 3);
  file.write("/mesh/segments", pairs, 2);
}

void write_table(Hdf5File& file, const ResultsTable& table) {
  const std::string name = "/model/" + table.name;
  if (!table.texts.empty())
    file.write(name, table.texts);
  else if (!table.integers.empty())
    file.write(name, table.integers, table.width);
  else
    file.write(name, table.numbers, table.width);
}

Hdf5File first_content(const ResultsMesh& mesh, const ResultsFile::Texts& provenance) {
  Hdf5File file = Hdf5File::in_memory();
  write_blocks(file, mesh);
  write_segments(file, mesh);
  const std::vector<std::int64_t> region(mesh.block_region.begin(), mesh.block_region.end());
  if (!region.empty()) file.write("/mesh/region", region);
  file.set_attribute("/mesh/vertices", "unit", mesh.length_unit);
  file.set_attribute("/mesh/segment_ends", "unit", mesh.length_unit);
  for (const ResultsTable& table : mesh.model) write_table(file, table);
  file.make_group("/field");
  file.make_group("/provenance");
  for (const auto& [name, text] : provenance) file.write("/provenance/" + name, std::vector{text});
  return file;
}

ResultsFile::Sizes sizes_of(const Hdf5File& file) {
  return {file.num_rows("/mesh/offsets") - 1, file.num_rows("/mesh/vertices"), file.num_rows("/mesh/mixed"),
          file.num_rows("/mesh/segments"), file.has("/mesh/region")};
}

std::string group_of(int step) { return fmt::format("/field/{:06}", step); }

bool on_segments(FieldPlace place) {
  return place == FieldPlace::segment || place == FieldPlace::segment_end;
}

ResultsFile::FieldEntry entry_of(const StoredField& field, int step) {
  const std::string group = group_of(step) + (on_segments(field.place) ? "/segments/" : "/");
  return {field.name, group + field.name, field.place, field.components == 2 ? 3 : field.components,
          field.labels};
}

std::vector<double> padded(const StoredField& field) {
  if (field.components != 2) return field.values;
  std::vector<double> values;
  values.reserve(field.values.size() / 2 * 3);
  for (std::size_t i = 0; i + 1 < field.values.size(); i += 2) {
    values.insert(values.end(), {field.values[i], field.values[i + 1], 0.0});
  }
  return values;
}

void write_field(Hdf5File& file, const StoredField& field, const ResultsFile::FieldEntry& entry) {
  file.write(entry.dataset, padded(field), static_cast<std::size_t>(entry.components));
  file.set_attribute(entry.dataset, "unit", field.unit);
  file.set_attribute(entry.dataset, "components", field.labels);
  file.set_attribute(entry.dataset, "place", static_cast<std::int64_t>(field.place));
}

/// Opens, changes, closes; every failure becomes an OutputError.
template <class Change>
void append(const fs::path& path, std::chrono::milliseconds patience, const Change& change) {
  try {
    Hdf5File file = Hdf5File::open_patiently(path, Hdf5File::Access::append, patience);
    change(file);
    file.close();
  } catch (const Hdf5Error& error) {
    throw OutputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
  }
}

ResultsFile::FieldEntry read_entry(const Hdf5File& file, const std::string& dataset) {
  const auto place = static_cast<FieldPlace>(file.integer_attribute(dataset, "place"));
  const std::size_t rows = std::max<std::size_t>(file.num_rows(dataset), 1);
  const auto components = static_cast<int>(file.numbers(dataset).size() / rows);
  return {dataset.substr(dataset.rfind('/') + 1), dataset, place, std::max(components, 1),
          file.text_attribute(dataset, "components")};
}

ResultsFile::StepEntry read_step(const Hdf5File& file, const std::string& group) {
  ResultsFile::StepEntry step{
      static_cast<int>(file.integer_attribute(group, "step")), file.number_attribute(group, "time"), {}};
  for (const std::string& name : file.members(group)) {
    if (name != "segments") step.fields.push_back(read_entry(file, group + "/" + name));
  }
  for (const std::string& name : file.members(group + "/segments")) {
    step.fields.push_back(read_entry(file, group + "/segments/" + name));
  }
  return step;
}

}  // namespace

ResultsFile::ResultsFile(const fs::path& folder) : path_(folder / "run.h5") {}

ResultsFile::ResultsFile(const fs::path& folder, const ResultsMesh& mesh, const Texts& provenance)
    : ResultsFile(folder) {
  try {
    const Hdf5File file = first_content(mesh, provenance);
    sizes_ = sizes_of(file);
    // The journal of an older file must not be taken for one of this.
    std::error_code ignored;
    fs::remove(path_.string() + ".journal", ignored);
    write_whole(path_, file.bytes(), Flush::to_system);
  } catch (const Hdf5Error& error) {
    throw OutputError(fmt::format("cannot write '{}': {}", path_.string(), error.what()));
  }
  write_xdmf();
}

ResultsFile ResultsFile::resume(const fs::path& folder, int last_step) {
  ResultsFile result(folder);
  try {
    Hdf5File file = Hdf5File::open_patiently(result.path_, Hdf5File::Access::append, result.patience_);
    result.sizes_ = sizes_of(file);
    for (const std::string& name : file.members("/field")) {
      const std::string group = "/field/" + name;
      // "time" is written last, so a step without it was cut short.
      const bool whole = file.has_attribute(group, "time");
      if (whole && file.integer_attribute(group, "step") <= last_step) {
        result.steps_.push_back(read_step(file, group));
      } else {
        file.remove(group);
      }
    }
    file.close();
  } catch (const Hdf5Error& error) {
    throw InputError(Position{result.path_.string()}, fmt::format("cannot be continued: {}", error.what()));
  }
  result.write_xdmf();
  return result;
}

void ResultsFile::check(const Snapshot& snapshot) const {
  if (!steps_.empty() && snapshot.step <= steps_.back().step) {
    throw std::invalid_argument(fmt::format("step {} is stored after {}", snapshot.step, steps_.back().step));
  }
  for (const StoredField& field : snapshot.fields) {
    const std::size_t wanted = num_places(sizes_, field.place) * static_cast<std::size_t>(field.components);
    if (field.values.size() == wanted) continue;
    throw std::invalid_argument(
        fmt::format("field '{}' has {} values, {} are wanted", field.name, field.values.size(), wanted));
  }
}

void ResultsFile::store(const Snapshot& snapshot) {
  check(snapshot);
  StepEntry entry{snapshot.step, snapshot.time, {}};
  append(path_, patience_, [&](Hdf5File& file) {
    const std::string group = group_of(snapshot.step);
    file.make_group(group);
    for (const StoredField& field : snapshot.fields) {
      entry.fields.push_back(entry_of(field, snapshot.step));
      write_field(file, field, entry.fields.back());
    }
    for (const auto& [name, value] : snapshot.numbers) file.set_attribute(group, name, value);
    file.set_attribute(group, "step", static_cast<std::int64_t>(snapshot.step));
    file.set_attribute(group, "time", snapshot.time);
  });
  steps_.push_back(std::move(entry));
  write_xdmf();
}

void ResultsFile::set_provenance(const std::string& name, const std::string& text) {
  append(path_, patience_, [&](Hdf5File& file) {
    const std::string dataset = "/provenance/" + name;
    if (file.has(dataset)) file.remove(dataset);
    file.write(dataset, std::vector{text});
  });
}

std::vector<int> ResultsFile::steps() const {
  std::vector<int> numbers;
  for (const StepEntry& step : steps_) numbers.push_back(step.step);
  return numbers;
}

bool ResultsFile::has(int step, const std::string& field) const {
  const auto entry = std::ranges::find(steps_, step, &StepEntry::step);
  return entry != steps_.end() &&
         std::ranges::find(entry->fields, field, &FieldEntry::name) != entry->fields.end();
}

std::vector<double> ResultsFile::numbers(int step, const std::string& field) const {
  try {
    return Hdf5File::open(path_, Hdf5File::Access::read).numbers(group_of(step) + "/" + field);
  } catch (const Hdf5Error& error) {
    throw OutputError(fmt::format("cannot read '{}' again: {}", path_.string(), error.what()));
  }
}

void ResultsFile::write_xdmf() const {
  // It can be made again from run.h5, so a power failure need not be waited for.
  write_whole(fs::path(path_).replace_extension(".xdmf"),
              xdmf_text(path_.filename().string(), sizes_, steps_), Flush::to_system);
}

}  // namespace dda
