#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "framework/files/run/results.hpp"

namespace dda {

/// The fields of a run read back: geometry, stored steps and their fields, see results.hpp.
///
/// The run may be unfinished: it has the steps that were stored when this was made. Fields of the interface
/// have the name "segments/<name>". Throws InputError (file, reason) when a file is absent or damaged.
class ResultsReader {
 public:
  explicit ResultsReader(const std::filesystem::path& folder);

  /// Without the model's tables.
  ResultsMesh mesh() const;
  /// The material of each region; empty where the folder does not say.
  std::vector<std::string> region_materials() const;
  /// Numbers of the stored steps, increasing.
  const std::vector<int>& steps() const { return steps_; }
  bool has(int step, const std::string& field) const;
  /// What cracks have made of the blocks, without its tables.
  CutBlocks cut(int step) const;
  /// Row-major; plane vectors have three components, the last one zero.
  std::vector<double> values(int step, const std::string& field) const;
  std::vector<std::int64_t> integers(int step, const std::string& table) const;
  std::string unit(int step, const std::string& field) const;
  ResultsTexts provenance() const;
  /// A table of the model; empty where there is none of this name.
  std::vector<std::int64_t> model(const std::string& table) const;

 private:
  std::filesystem::path folder_;
  std::vector<int> steps_;
};

}  // namespace dda
