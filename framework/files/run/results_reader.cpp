#include "framework/files/run/results_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/base/errors.hpp"
#include "framework/files/run/hdf5_file.hpp"

namespace dda {
namespace fs = std::filesystem;
namespace {

/// The points of an [n,3] array, without their zero z.
std::vector<Vec2> plane(const std::vector<double>& values) {
  std::vector<Vec2> out;
  out.reserve(values.size() / 3);
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) out.emplace_back(values[i], values[i + 1]);
  return out;
}

std::vector<std::vector<Vec2>> outlines(const Hdf5File& file, const std::string& group) {
  const std::vector<Vec2> vertices = plane(file.numbers(group + "/vertices"));
  const std::vector<std::int64_t> offsets = file.integers(group + "/offsets");
  if (offsets.empty() || offsets.back() != static_cast<std::int64_t>(vertices.size()))
    throw Hdf5Error("its blocks do not fit its vertices");
  if (offsets.front() < 0 || !std::ranges::is_sorted(offsets)) throw Hdf5Error("its blocks are in no order");
  std::vector<std::vector<Vec2>> out;
  for (std::size_t b = 0; b + 1 < offsets.size(); ++b)
    out.emplace_back(vertices.begin() + offsets[b], vertices.begin() + offsets[b + 1]);
  return out;
}

std::vector<std::array<Vec2, 2>> lines(const Hdf5File& file, const std::string& name) {
  const std::vector<Vec2> ends = plane(file.numbers(name));
  std::vector<std::array<Vec2, 2>> out;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) out.push_back({ends[i], ends[i + 1]});
  return out;
}

/// What `read` finds in a file.
template <class Read>
auto reading(const fs::path& path, const Read& read) {
  try {
    return read(Hdf5File::open(path));
  } catch (const Hdf5Error& error) {
    throw InputError(Position{path.string()}, fmt::format("cannot be read: {}", error.what()));
  }
}

}  // namespace

ResultsReader::ResultsReader(const fs::path& folder) : folder_(folder), steps_(stored_steps(folder)) {
  reading(folder_ / mesh_file, [](const Hdf5File&) {});
}

ResultsMesh ResultsReader::mesh() const {
  return reading(folder_ / mesh_file, [](const Hdf5File& file) {
    ResultsMesh out{.blocks = outlines(file, "/mesh"),
                    .block_region = {},
                    .segments = lines(file, "/mesh/segment_ends"),
                    .length_unit = {}};
    if (file.has("/mesh/region"))
      for (const std::int64_t region : file.integers("/mesh/region"))
        out.block_region.push_back(static_cast<int>(region));
    out.length_unit = file.text_attribute("/mesh/vertices", "unit");
    return out;
  });
}

std::vector<std::string> ResultsReader::region_materials() const {
  return reading(folder_ / mesh_file, [](const Hdf5File& file) {
    const std::string table = std::string("/model/") + region_materials_table;
    return file.has(table) ? file.texts(table) : std::vector<std::string>{};
  });
}

CutBlocks ResultsReader::cut(int step) const {
  return reading(folder_ / step_file(step), [](const Hdf5File& file) {
    CutBlocks out;
    if (file.has("/parts")) {
      out.parts = outlines(file, "/parts");
      for (const std::int64_t block : file.integers("/parts/block"))
        out.part_block.push_back(static_cast<std::size_t>(block));
    }
    if (file.has("/cracks")) out.pieces = lines(file, "/cracks/ends");
    return out;
  });
}

bool ResultsReader::has(int step, const std::string& field) const {
  return reading(folder_ / step_file(step), [&](const Hdf5File& file) { return file.has("/" + field); });
}

std::vector<double> ResultsReader::values(int step, const std::string& field) const {
  return reading(folder_ / step_file(step), [&](const Hdf5File& file) { return file.numbers("/" + field); });
}

std::vector<std::int64_t> ResultsReader::integers(int step, const std::string& table) const {
  return reading(folder_ / step_file(step), [&](const Hdf5File& file) { return file.integers("/" + table); });
}

std::string ResultsReader::unit(int step, const std::string& field) const {
  return reading(folder_ / step_file(step),
                 [&](const Hdf5File& file) { return file.text_attribute("/" + field, "unit"); });
}

ResultsTexts ResultsReader::provenance() const {
  return reading(folder_ / mesh_file, [](const Hdf5File& file) {
    ResultsTexts out;
    for (const std::string& name : file.members("/provenance"))
      for (const std::string& text : file.texts("/provenance/" + name)) out[name] += text;
    return out;
  });
}

std::vector<std::int64_t> ResultsReader::model(const std::string& table) const {
  return reading(folder_ / mesh_file, [&](const Hdf5File& file) {
    const std::string name = "/model/" + table;
    return file.has(name) ? file.integers(name) : std::vector<std::int64_t>{};
  });
}

}  // namespace dda
