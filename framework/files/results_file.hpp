#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda {

/// Given numbers or texts that do not change from step to step, under /model/<name>: one of the three lists.
struct ResultsTable {
  std::string name;
  std::vector<double> numbers;
  std::vector<std::int64_t> integers;
  std::vector<std::string> texts;
  std::size_t width = 1;  ///< columns
};

/// The geometry that fields are given on, and the model's tables; written once.
struct ResultsMesh {
  std::vector<std::vector<Vec2>> blocks;      ///< outline of every block, reference position [L]
  std::vector<int> block_region;              ///< one number per block, or empty
  std::vector<std::array<Vec2, 2>> segments;  ///< interface segments, reference position [L]; may be empty
  std::string length_unit;
  std::vector<ResultsTable> model = {};
};

/// What one row of a field belongs to.
enum class FieldPlace { block, block_vertex, segment, segment_end };

/// A named array over the blocks, their vertices (block after block, in the order of their outlines), the
/// segments, or the segments' two ends.
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

/// The fields of one stored step. A field `displacement` on block_vertex (and one on segment_end) moves the
/// picture in ParaView's "Warp By Vector".
struct Snapshot {
  int step = 0;
  double time = 0;                        ///< ParaView's time: step number or load factor
  std::map<std::string, double> numbers;  ///< kept as attributes of the step, such as load_factor
  std::vector<StoredField> fields;
};

/// `run.h5` and `run.xdmf`: fields of the stored steps, readable by ParaView and h5py while the run goes on.
///
///     /mesh/vertices [n,3]  /mesh/offsets [blocks+1]  /mesh/mixed  /mesh/region  /mesh/segment_ends [2m,3]
///     /model/<name>                              what the run can be checked from, see ResultsTable
///     /field/000034/displacement [n,3]           one dataset per field per step, unit as attribute
///     /provenance/<name>                         texts
///
/// Segment fields stand in the group /field/000034/segments. Every store opens, appends and closes, so that
/// all steps stored before a kill stay readable; run.xdmf is renewed whole after each. A reader that holds
/// the file's lock is waited for up to `patience`. Throws OutputError (file, reason).
class ResultsFile {
 public:
  using Texts = std::map<std::string, std::string>;

  /// Starts run.h5 and run.xdmf in `folder`; `provenance` holds decks, version, seed, host and the like.
  ResultsFile(const std::filesystem::path& folder, const ResultsMesh& mesh, const Texts& provenance);
  /// Continues the file of an earlier run, dropping the steps after `last_step`.
  /// Throws InputError when there is no such file or it is damaged.
  static ResultsFile resume(const std::filesystem::path& folder, int last_step);

  /// Appends a step; steps must increase. Throws std::invalid_argument for sizes that do not fit the mesh.
  void store(const Snapshot& snapshot);
  /// Adds or replaces a text under /provenance, such as the wall time at the end.
  void set_provenance(const std::string& name, const std::string& text);
  void set_patience(std::chrono::milliseconds patience) { patience_ = patience; }
  const std::filesystem::path& path() const { return path_; }
  std::vector<int> steps() const;
  /// Whether a stored step has a field, and its numbers, row-major and three wide where two were given.
  bool has(int step, const std::string& field) const;
  std::vector<double> numbers(int step, const std::string& field) const;

  /// What run.xdmf says about one field and one step.
  struct FieldEntry {
    std::string name;
    std::string dataset;
    FieldPlace place;
    int components;
    std::string labels = {};  ///< of the components, "n s"; those beyond them are zero
  };
  struct StepEntry {
    int step;
    double time;
    std::vector<FieldEntry> fields;
  };
  struct Sizes {
    std::size_t blocks = 0, vertices = 0, mixed = 0, segments = 0;
    bool has_region = false;
  };

 private:
  explicit ResultsFile(const std::filesystem::path& folder);
  void write_xdmf() const;
  void check(const Snapshot& snapshot) const;

  std::filesystem::path path_;
  std::chrono::milliseconds patience_{10000};
  Sizes sizes_;
  std::vector<StepEntry> steps_;
};

}  // namespace dda
