#include "framework/files/run/results_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "framework/base/errors.hpp"
#include "framework/files/run/hdf5_file.hpp"
#include "framework/files/whole_file.hpp"

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

using Outlines = std::vector<std::vector<Vec2>>;

/// Polygons of a group: each its own vertices.
void write_outlines(Hdf5File& file, const std::string& group, const Outlines& outlines) {
  std::vector<Vec2> vertices;
  std::vector<std::int64_t> mixed, offsets = {0};
  for (const auto& outline : outlines) {
    mixed.insert(mixed.end(), {xdmf_polygon, static_cast<std::int64_t>(outline.size())});
    for (const Vec2& vertex : outline) {
      mixed.push_back(static_cast<std::int64_t>(vertices.size()));
      vertices.push_back(vertex);
    }
    offsets.push_back(static_cast<std::int64_t>(vertices.size()));
  }
  file.write(group + "/vertices", in_space(vertices), 3);
  file.write(group + "/offsets", offsets);
  file.write(group + "/mixed", mixed);
}

/// The blocks with those left out that are cut: what is left of them has no area.
std::vector<std::int64_t> whole_blocks(const std::vector<std::int64_t>& offsets, const CutBlocks& cut) {
  std::vector<std::int64_t> out;
  for (std::size_t b = 0; b + 1 < offsets.size(); ++b) {
    const bool is_cut = std::ranges::binary_search(cut.part_block, b);
    const std::int64_t count = is_cut ? 3 : offsets[b + 1] - offsets[b];
    out.insert(out.end(), {xdmf_polygon, count});
    for (std::int64_t v = 0; v < count; ++v) out.push_back(offsets[b] + (is_cut ? 0 : v));
  }
  return out;
}

void write_lines(Hdf5File& file, const std::string& lines, const std::string& ends,
                 const std::vector<std::array<Vec2, 2>>& segments) {
  std::vector<Vec2> points;
  std::vector<std::int64_t> pairs;
  for (const auto& [start, end] : segments) {
    const auto first = static_cast<std::int64_t>(points.size());
    points.insert(points.end(), {start, end});
    pairs.insert(pairs.end(), {first, first + 1});
  }
  file.write(ends, in_space(points), 3);
  file.write(lines, pairs, 2);
}

void write_table(Hdf5File& file, const std::string& group, const ResultsTable& table) {
  const std::string name = group + "/" + table.name;
  if (!table.texts.empty())
    file.write(name, table.texts);
  else if (!table.integers.empty())
    file.write(name, table.integers, table.width);
  else
    file.write(name, table.numbers, table.width);
}

void write_mesh(Hdf5File& file, const ResultsMesh& mesh) {
  write_outlines(file, "/mesh", mesh.blocks);
  write_lines(file, "/mesh/segments", "/mesh/segment_ends", mesh.segments);
  const std::vector<std::int64_t> region(mesh.block_region.begin(), mesh.block_region.end());
  if (!region.empty()) file.write("/mesh/region", region);
  if (!mesh.region_names.empty()) file.write("/mesh/region_names", mesh.region_names);
  file.set_attribute("/mesh/vertices", "unit", mesh.length_unit);
  file.set_attribute("/mesh/segment_ends", "unit", mesh.length_unit);
  for (const ResultsTable& table : mesh.model) write_table(file, "/model", table);
}

XdmfSizes sizes_of(const Hdf5File& file) {
  XdmfSizes out{file.num_rows("/mesh/offsets") - 1, file.num_rows("/mesh/vertices"),
                file.num_rows("/mesh/mixed"), file.num_rows("/mesh/segments"), file.has("/mesh/region")};
  if (file.has("/mesh/region_names")) out.regions = file.texts("/mesh/region_names");
  return out;
}

XdmfCuts cuts_of(const Hdf5File& file) {
  XdmfCuts out;
  if (file.has("/parts"))
    out = {file.num_rows("/parts/block"), file.num_rows("/parts/vertices"), file.num_rows("/parts/mixed"),
           file.num_rows("/parts/whole")};
  if (file.has("/cracks")) out.pieces = file.num_rows("/cracks/lines");
  return out;
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

/// See results.hpp.
void write_views(Hdf5File& file, const StoredField& field) {
  const std::string dataset = dataset_of(field.name, field.place);
  if (field.labels == normal_and_sliding) {
    file.write_view(dataset + "_n", 1, {{dataset, 0, 0}});
    file.write_view(dataset + "_s", 1, {{dataset, 1, 0}});
  }
  if (!is_tensor(field.labels)) return;
  ViewedColumn shear{dataset, 2};
  if (field.labels == strain_labels) {
    shear = {dataset + "_xy", 0};
    std::vector<double> half;
    for (std::size_t i = 2; i < field.values.size(); i += 3) half.push_back(field.values[i] / 2);
    file.write(shear.array, half);
  }
  std::vector<ViewedColumn> columns{
      {dataset, 0, 0}, {shear.array, shear.column, 1}, {shear.array, shear.column, 3}, {dataset, 1, 4}};
  if (const std::string zz = out_of_plane_of(dataset); file.has(zz)) columns.push_back({zz, 0, 8});
  file.write_view(tensor_of(dataset), 9, columns);
}

void write_field(Hdf5File& file, const StoredField& field) {
  const std::string dataset = dataset_of(field.name, field.place);
  file.write(dataset, padded(field), static_cast<std::size_t>(entry_of(field).components));
  file.set_attribute(dataset, "unit", field.unit);
  file.set_attribute(dataset, "components", field.labels);
  file.set_attribute(dataset, "place", static_cast<std::int64_t>(field.place));
  if (!field.values.empty()) write_views(file, field);
}

void write_cut(Hdf5File& file, const CutBlocks& cut, const std::vector<std::int64_t>& offsets) {
  if (!cut.parts.empty()) {
    write_outlines(file, "/parts", cut.parts);
    file.write("/parts/block", std::vector<std::int64_t>(cut.part_block.begin(), cut.part_block.end()));
    file.write("/parts/whole", whole_blocks(offsets, cut));
  }
  if (!cut.pieces.empty()) write_lines(file, "/cracks/lines", "/cracks/ends", cut.pieces);
  for (const ResultsTable& table : cut.tables) write_table(file, "", table);
}

/// Of the parts those of their blocks.
void write_regions(Hdf5File& file, const CutBlocks& cut, const std::vector<std::int64_t>& regions) {
  if (cut.parts.empty() || regions.empty()) return;
  std::vector<std::int64_t> of_parts;
  for (const std::size_t block : cut.part_block) of_parts.push_back(regions[block]);
  file.write("/parts/region", of_parts);
}

void write_step(Hdf5File& file, const Snapshot& snapshot) {
  for (const StoredField& field : snapshot.fields) write_field(file, field);
  for (const ResultsTable& table : snapshot.tables) write_table(file, "", table);
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
  step.cuts = cuts_of(file);
  for (const std::string& name : file.attributes("/"))
    if (name != "step" && name != "time") step.numbers[name] = file.number_attribute("/", name);
  for (const std::string group : {"", "/segments", "/parts", "/cracks"})
    for (const std::string& name : file.members(group.empty() ? "/" : group))
      if (const std::string dataset = group + "/" + name; file.has_attribute(dataset, "place"))
        step.fields.push_back(read_entry(file, dataset));
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
  renew(mesh, provenance);
  write_xdmf();
}

void ResultsWriter::renew(const ResultsMesh& mesh, const ResultsTexts& provenance) {
  write_file(folder_ / mesh_file, [&](Hdf5File& file) {
    write_mesh(file, mesh);
    for (const auto& [name, text] : provenance) file.write("/provenance/" + name, std::vector{text});
    read_mesh(file);
  });
}

ResultsWriter ResultsWriter::resume(const fs::path& folder, int last_step) {
  ResultsWriter result(folder);
  make_room(folder / fields_folder, last_step);
  read_again(folder / mesh_file, [&](const Hdf5File& file) { result.read_mesh(file); });
  for (const int step : stored_steps(folder))
    result.steps_.push_back(read_again(folder / step_file(step), read_step));
  result.write_xdmf();
  return result;
}

void ResultsWriter::read_mesh(const Hdf5File& file) {
  sizes_ = sizes_of(file);
  offsets_ = file.integers("/mesh/offsets");
  if (sizes_.has_region) regions_ = file.integers("/mesh/region");
}

void ResultsWriter::check(const Snapshot& snapshot, const XdmfCuts& cuts) const {
  if (!steps_.empty() && snapshot.step <= steps_.back().step) {
    throw std::invalid_argument(fmt::format("step {} is stored after {}", snapshot.step, steps_.back().step));
  }
  for (const StoredField& field : snapshot.fields) {
    const std::size_t wanted =
        num_places(sizes_, cuts, field.place) * static_cast<std::size_t>(field.components);
    if (field.values.size() == wanted) continue;
    throw std::invalid_argument(
        fmt::format("field '{}' has {} values, {} are wanted", field.name, field.values.size(), wanted));
  }
}

void ResultsWriter::store(const Snapshot& snapshot) {
  XdmfStep entry{snapshot.step, snapshot.time, {}, {}, snapshot.numbers};
  write_file(folder_ / step_file(snapshot.step), [&](Hdf5File& file) {
    write_cut(file, snapshot.cut, offsets_);
    write_regions(file, snapshot.cut, regions_);
    entry.cuts = cuts_of(file);
    check(snapshot, entry.cuts);
    write_step(file, snapshot);
  });
  for (const StoredField& field : snapshot.fields) entry.fields.push_back(entry_of(field));
  steps_.push_back(std::move(entry));
  write_xdmf();
}

std::vector<int> ResultsWriter::steps() const {
  std::vector<int> numbers;
  for (const XdmfStep& step : steps_) numbers.push_back(step.step);
  return numbers;
}

void ResultsWriter::remove(const std::function<bool(double)>& is_needless) {
  std::vector<fs::path> needless;
  std::erase_if(steps_, [&](const XdmfStep& step) {
    const bool is_one = is_needless(step.time);
    if (is_one) needless.push_back(folder_ / step_file(step.step));
    return is_one;
  });
  write_xdmf();
  for (const fs::path& file : needless) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw OutputError(fmt::format("cannot remove '{}': {}", file.string(), error.message()));
  }
}

void ResultsWriter::write_xdmf() const {
  // It can be made again from the fields, so a power failure need not be waited for.
  write_whole(folder_ / "run.xdmf", xdmf_text(sizes_, steps_), Flush::to_system);
}

}  // namespace dda
