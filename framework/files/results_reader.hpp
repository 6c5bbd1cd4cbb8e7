#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "framework/files/results_file.hpp"

namespace dda {

class Hdf5File;

/// `run.h5` read back: geometry, stored steps and their fields.
///
/// It may belong to a run that is unfinished: a step that a kill cut short is left out. A writer that holds
/// the file's lock is waited for, and waits itself while this is open. Fields of the interface have the name
/// "segments/<name>". Throws InputError (file, reason) when the file is absent or damaged.
class ResultsReader {
 public:
  explicit ResultsReader(const std::filesystem::path& folder);
  ~ResultsReader();

  ResultsMesh mesh() const;
  /// Numbers of the whole steps, increasing.
  const std::vector<int>& steps() const { return steps_; }
  bool has(int step, const std::string& field) const;
  /// Row-major; plane vectors have three components, the last one zero.
  std::vector<double> values(int step, const std::string& field) const;
  std::string unit(int step, const std::string& field) const;
  ResultsFile::Texts provenance() const;

 private:
  template <class Read>
  auto reading(const Read& read) const;

  std::filesystem::path path_;
  std::unique_ptr<Hdf5File> file_;
  std::vector<int> steps_;
};

}  // namespace dda
