#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "framework/files/run/xdmf.hpp"

namespace dda {

class Hdf5File;

/// Writes `fields/` (see results.hpp) and `run.xdmf`, which ParaView and h5py can read while the run goes on.
///
/// A kill or a full disk leaves the steps stored before whole; run.xdmf is renewed whole after each store.
/// Throws OutputError (file, reason).
class ResultsWriter {
 public:
  /// Writes the mesh and a run.xdmf without steps into `folder`, which holds no fields yet.
  ResultsWriter(const std::filesystem::path& folder, const ResultsMesh& mesh, const ResultsTexts& provenance);
  /// Continues the fields of an earlier run: removes the steps after `last_step` and what a kill left half
  /// written. Throws InputError when there is no mesh, or a file is damaged.
  static ResultsWriter resume(const std::filesystem::path& folder, int last_step);

  /// Writes the mesh anew, whose model's tables have become others; blocks and segments are the same.
  void renew(const ResultsMesh& mesh, const ResultsTexts& provenance);
  /// Adds a step; steps must increase. Throws std::invalid_argument for sizes that do not fit the mesh.
  void store(const Snapshot& snapshot);
  std::vector<int> steps() const;
  /// Removes steps by their time.
  void remove(const std::function<bool(double)>& is_needless);

 private:
  explicit ResultsWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void read_mesh(const Hdf5File& file);
  void write_xdmf() const;
  void check(const Snapshot& snapshot, const XdmfCuts& cuts) const;

  std::filesystem::path folder_;
  XdmfSizes sizes_;
  std::vector<std::int64_t> offsets_;  ///< of the blocks' vertices
  std::vector<std::int64_t> regions_;  ///< of the blocks, or empty
  std::vector<XdmfStep> steps_;
};

}  // namespace dda
