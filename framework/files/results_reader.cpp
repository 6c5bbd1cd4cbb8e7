#include "framework/files/results_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include "framework/base/errors.hpp"
#include "framework/files/hdf5_file.hpp"

namespace dda {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds patience{10000};

std::string name_of(int step, const std::string& field) {
  return fmt::format("/field/{:06}/{}", step, field);
}

/// The points of an [n,3] array, without their zero z.
std::vector<Vec2> plane(const std::vector<double>& values) {
  std::vector<Vec2> out;
  out.reserve(values.size() / 3);
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) out.emplace_back(values[i], values[i + 1]);
  return out;
}

std::vector<std::vector<Vec2>> outlines(const Hdf5File& file) {
  const std::vector<Vec2> vertices = plane(file.numbers("/mesh/vertices"));
  const std::vector<std::int64_t> offsets = file.integers("/mesh/offsets");
  if (offsets.empty() || offsets.back() != static_cast<std::int64_t>(vertices.size()))
    throw Hdf5Error("its blocks do not fit its vertices");
  if (offsets.front() < 0 || !std::ranges::is_sorted(offsets)) throw Hdf5Error("its blocks are in no order");
  std::vector<std::vector<Vec2>> out;
  for (std::size_t b = 0; b + 1 < offsets.size(); ++b)
    out.emplace_back(vertices.begin() + offsets[b], vertices.begin() + offsets[b + 1]);
  return out;
}

std::vector<int> whole_steps(const Hdf5File& file) {
  std::vector<int> out;
  for (const std::string& name : file.members("/field")) {
    const std::string group = "/field/" + name;
    // "time" is written last, so a step without it was cut short.
    if (file.has_attribute(group, "time"))
      out.push_back(static_cast<int>(file.integer_attribute(group, "step")));
  }
  return out;
}

}  // namespace

template <class Read>
auto ResultsReader::reading(const Read& read) const {
  try {
    return read();
  } catch (const Hdf5Error& error) {
    throw InputError(Position{path_.string()}, fmt::format("cannot be read: {}", error.what()));
  } catch (const std::bad_alloc&) {
    throw InputError(Position{path_.string()}, "cannot be read: it claims more values than fit into memory");
  } catch (const std::length_error&) {
    throw InputError(Position{path_.string()}, "cannot be read: it claims more values than there can be");
  }
}

ResultsReader::ResultsReader(const fs::path& folder) : path_(folder / "run.h5") {
  reading([&] {
    file_ = std::make_unique<Hdf5File>(Hdf5File::open_patiently(path_, Hdf5File::Access::read, patience));
    steps_ = whole_steps(*file_);
  });
}

ResultsReader::~ResultsReader() = default;

ResultsMesh ResultsReader::mesh() const {
  return reading([&] {
    ResultsMesh out{.blocks = outlines(*file_), .block_region = {}, .segments = {}, .length_unit = {}};
    if (file_->has("/mesh/region"))
      for (const std::int64_t region : file_->integers("/mesh/region"))
        out.block_region.push_back(static_cast<int>(region));
    const std::vector<Vec2> ends = plane(file_->numbers("/mesh/segment_ends"));
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) out.segments.push_back({ends[i], ends[i + 1]});
    out.length_unit = file_->text_attribute("/mesh/vertices", "unit");
    return out;
  });
}

bool ResultsReader::has(int step, const std::string& field) const {
  return reading([&] { return file_->has(name_of(step, field)); });
}

std::vector<double> ResultsReader::values(int step, const std::string& field) const {
  return reading([&] { return file_->numbers(name_of(step, field)); });
}

std::string ResultsReader::unit(int step, const std::string& field) const {
  return reading([&] { return file_->text_attribute(name_of(step, field), "unit"); });
}

ResultsFile::Texts ResultsReader::provenance() const {
  return reading([&] {
    ResultsFile::Texts out;
    for (const std::string& name : file_->members("/provenance"))
      for (const std::string& text : file_->texts("/provenance/" + name)) out[name] += text;
    return out;
  });
}

}  // namespace dda
