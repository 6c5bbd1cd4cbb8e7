#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda {

/// The fields of a run in its folder: the mesh and, for each stored step, a file of its own.
///
///     fields/mesh.h5     /mesh/vertices [n,3]  /mesh/offsets [blocks+1]  /mesh/mixed  /mesh/region  /mesh/region_names
///                        /mesh/segments [m,2]  /mesh/segment_ends [2m,3]
///                        /model/<name>         what the run can be checked from, see ResultsTable
///                        /provenance/<name>    texts
///     fields/000034.h5   /displacement [n,3]   a dataset per field, its unit as attribute;
///                        /segments/damage [m]  those of segments; step, time and numbers at the root
///     and where cracks cut blocks at that step
///                        /parts/vertices [k,3]  /parts/offsets [parts+1]  /parts/mixed  /parts/block  /parts/region
///                        /parts/whole          /mesh/mixed, each cut block shrunk to its first vertex
///                        /cracks/lines [c,2]  /cracks/ends [2c,3]        pieces of cracks
///                        /parts/stress, /cracks/damage, …                fields of either
///                        /<name>               tables, see CutBlocks
///     for ParaView, whose readers take no part of an array, views that hold no numbers themselves
///                        /stress_tensor [n,9]  of tensors "xx yy xy" and "xx yy 2xy"; of these /strain_xy is half the 2xy
///                        /segments/opening_n [m]  /segments/opening_s [m]                 of "n s"
///
/// A file appears whole, through a renaming, and is never written to again: readers need no lock. Behind its
/// bytes stands their checksum (seal.hpp), without which none of them is opened.
inline constexpr const char* fields_folder = "fields";
inline constexpr const char* mesh_file = "fields/mesh.h5";
std::string step_file(int step);

/// The step whose file this is; nothing for any other file.
std::optional<int> step_of(const std::filesystem::path& file);

/// Numbers of the steps stored in a run folder, increasing.
std::vector<int> stored_steps(const std::filesystem::path& run_folder);

/// Given numbers or texts, one of the three lists: of the model under /model/<name>.
struct ResultsTable {
  std::string name;
  std::vector<double> numbers;
  std::vector<std::int64_t> integers;
  std::vector<std::string> texts;
  std::size_t width = 1;  ///< columns
};

/// The model's table with the material of each region, a text.
inline constexpr const char* region_materials_table = "region_materials";

/// The geometry that fields are given on, and the model's tables; written once.
struct ResultsMesh {
  std::vector<std::vector<Vec2>> blocks;       ///< outline of every block, reference position [L]
  std::vector<int> block_region;               ///< one number per block, or empty
  std::vector<std::string> region_names = {};  ///< by these numbers; may be empty
  std::vector<std::array<Vec2, 2>> segments;   ///< interface segments, reference position [L]; may be empty
  std::string length_unit;
  std::vector<ResultsTable> model = {};
};

/// Where a run comes from: decks, version, seed, host and the like, by name.
using ResultsTexts = std::map<std::string, std::string>;

/// What one row of a field belongs to.
enum class FieldPlace { block, block_vertex, segment, segment_end, part, part_vertex, crack, crack_end };

/// A named array over the blocks, their vertices (block after block, in the order of their outlines), the
/// segments, or the segments' two ends; or over the parts of cut blocks, their vertices, the pieces of cracks, or
/// their two ends.
///
/// values: row-major, one row per place, `components` wide. Two components are stored as three with a zero z,
/// because ParaView knows no plane vectors. `labels` names them in the file, such as "xx yy xy" or "n s".
struct StoredField {
  std::string name;
  std::string unit;
  FieldPlace place = FieldPlace::block;
  int components = 1;
  std::vector<double> values;
  std::string labels;
};

/// The dataset of a field in the file of its step.
std::string dataset_of(const std::string& field, FieldPlace place);

/// Labels of fields of which there are views.
inline constexpr const char *normal_and_sliding = "n s", *stress_labels = "xx yy xy",
                            *strain_labels = "xx yy 2xy";
inline bool is_tensor(const std::string& labels) {
  return labels == stress_labels || labels == strain_labels;
}
/// The view of a tensor: all nine components, those out of the plane 0 but for the one that its own field has, which is
/// written before it.
inline std::string tensor_of(const std::string& name) { return name + "_tensor"; }
inline std::string out_of_plane_of(const std::string& name) { return name + "_zz"; }

/// What cracks have made of the blocks at a step. Empty where none is cut.
struct CutBlocks {
  std::vector<std::vector<Vec2>> parts;     ///< outlines of the parts of cut blocks, reference position [L]
  std::vector<std::size_t> part_block;      ///< to which each belongs
  std::vector<std::array<Vec2, 2>> pieces;  ///< of cracks, reference position [L]
  std::vector<ResultsTable> tables = {};    ///< under /<name>, such as "cracks/crack"

  bool empty() const { return parts.empty() && pieces.empty(); }
};

/// The fields of one stored step. A field `displacement` on the vertices or ends of a grid moves it in ParaView's
/// "Warp By Vector".
struct Snapshot {
  int step = 0;
  double time = 0;                        ///< ParaView's time: step number or load factor
  std::map<std::string, double> numbers;  ///< kept as attributes of the step, such as load_factor
  std::vector<StoredField> fields;
  CutBlocks cut = {};
  std::vector<ResultsTable> tables = {};
};

}  // namespace dda
