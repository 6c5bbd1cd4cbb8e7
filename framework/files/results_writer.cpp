#include "framework/files/results_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "framework/base/errors.hpp"
#include "framework/files/hdf5_file.hpp"
#include "framework/files/run_folder.hpp"

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

void write_mesh(Hdf5File& file, const ResultsMesh& mesh) {
  write_blocks(file, mesh);
  write_segments(file, mesh);
  const std::vector<std::int64_t> region(mesh.block_region.begin(), mesh.block_region.end());
  if (!region.empty()) file.write("/mesh/region", region);
  file.set_attribute("/mesh/vertices", "unit", mesh.length_unit);
  file.set_attribute("/mesh/segment_ends", "unit", mesh.length_unit);
  for (const ResultsTable& table : mesh.model) write_table(file, table);
}

XdmfSizes sizes_of(const Hdf5File& file) {
  return {file.num_rows("/mesh/offsets") - 1, file.num_rows("/mesh/vertices"), file.num_rows("/mesh/mixed"),
          file.num_rows("/mesh/segments"), file.has("/mesh/region")};
}

XdmfField entry_of(const StoredField& field) {
  return {field.name, field.place, field.components == 2 ? 3 : field.components, field.labels};
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

void write_field(Hdf5File& file, const StoredField& field) {
  const std::string dataset = dataset_of(field.name, field.place);
  file.write(dataset, padded(field), static_cast<std::size_t>(entry_of(field).components));
  file.set_attribute(dataset, "unit", field.unit);
  file.set_attribute(dataset, "components", field.labels);
  file.set_attribute(dataset, "place", static_cast<std::int64_t>(field.place));
}

void write_step(Hdf5File& file, const Snapshot& snapshot) {
  for (const StoredField& field : snapshot.fields) write_field(file, field);
  for (const auto& [name, value] : snapshot.numbers) file.set_attribute("/", name, value);
  file.set_attribute("/", "step", static_cast<std::int64_t>(snapshot.step));
  file.set_attribute("/", "time", snapshot.time);
}

/// Writes what `fill` puts into a file, whole or not at all.
template <class Fill>
void write_file(const fs::path& path, const Fill& fill) {
  try {
    Hdf5File file = Hdf5File::in_memory();
    fill(file);
    write_whole(path, file.bytes(), Flush::to_system);
  } catch (const Hdf5Error& error) {
    throw OutputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
  }
}

template <class Read>
auto read_again(const fs::path& path, const Read& read) {
  try {
    return read(Hdf5File::open(path));
  } catch (const Hdf5Error& error) {
    throw InputError(Position{path.string()}, fmt::format("cannot be continued: {}", error.what()));
  }
}

XdmfField read_entry(const Hdf5File& file, const std::string& dataset) {
  const auto place = static_cast<FieldPlace>(file.integer_attribute(dataset, "place"));
  const std::size_t rows = std::max<std::size_t>(file.num_rows(dataset), 1);
  const auto components = static_cast<int>(file.numbers(dataset).size() / rows);
  return {dataset.substr(dataset.rfind('/') + 1), place, std::max(components, 1),
          file.text_attribute(dataset, "components")};
}

XdmfStep read_step(const Hdf5File& file) {
  XdmfStep step{
      static_cast<int>(file.integer_attribute("/", "step")), file.number_attribute("/", "time"), {}};
  for (const std::string& name : file.members("/"))
    if (name != "segments") step.fields.push_back(read_entry(file, "/" + name));
  for (const std::string& name : file.members("/segments"))
    step.fields.push_back(read_entry(file, "/segments/" + name));
  return step;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("cannot make '{}': {}", folder.string(), error.message()));
}

/// A step behind the restart, or what was being written when the run was killed.
bool is_in_the_way(const fs::path& file, int last_step) {
  return file.extension() == ".part" || step_of(file).value_or(last_step) > last_step;
}

void make_room(const fs::path& fields, int last_step) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(fields, error)) {
    if (!is_in_the_way(entry.path(), last_step)) continue;
    fs::remove(entry.path(), error);
    if (error)
      throw OutputError(fmt::format("cannot remove '{}': {}", entry.path().string(), error.message()));
  }
}

}  // namespace

ResultsWriter::ResultsWriter(const fs::path& folder, const ResultsMesh& mesh, const ResultsTexts& provenance)
    : ResultsWriter(folder) {
  make_folder(folder / fields_folder);
  write_file(folder / mesh_file, [&](Hdf5File& file) {
    write_mesh(file, mesh);
    for (const auto& [name, text] : provenance) file.write("/provenance/" + name, std::vector{text});
    sizes_ = sizes_of(file);
  });
  write_xdmf();
}

ResultsWriter ResultsWriter::resume(const fs::path& folder, int last_step) {
  ResultsWriter result(folder);
  make_room(folder / fields_folder, last_step);
  result.sizes_ = read_again(folder / mesh_file, sizes_of);
  for (const int step : stored_steps(folder))
    result.steps_.push_back(read_again(folder / step_file(step), read_step));
  result.write_xdmf();
  return result;
}

void ResultsWriter::check(const Snapshot& snapshot) const {
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

void ResultsWriter::store(const Snapshot& snapshot) {
  check(snapshot);
  write_file(folder_ / step_file(snapshot.step), [&](Hdf5File& file) { write_step(file, snapshot); });
  XdmfStep entry{snapshot.step, snapshot.time, {}};
  for (const StoredField& field : snapshot.fields) entry.fields.push_back(entry_of(field));
  steps_.push_back(std::move(entry));
  write_xdmf();
}

std::vector<int> ResultsWriter::steps() const {
  std::vector<int> numbers;
  for (const XdmfStep& step : steps_) numbers.push_back(step.step);
  return numbers;
}

void ResultsWriter::write_xdmf() const {
  // It can be made again from the fields, so a power failure need not be waited for.
  write_whole(folder_ / "run.xdmf", xdmf_text(sizes_, steps_), Flush::to_system);
}

}  // namespace dda
