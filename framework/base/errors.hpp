#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace dda {

/// Where in the user's input something stands: file, line and column (both from 1; 0 = the whole file).
struct Position {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "beam.yaml:12:5", "beam.yaml" or "" when nothing is known.
std::string to_string(const Position& where);

/// One thing wrong with the user's input: where, and what to do about it.
struct Finding {
  Position where;
  std::string what;
};

/// The user's input cannot be used. Holds every finding and prints the first ones. The program exits with 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Finding> findings);
  InputError(Position where, std::string what);
  const std::vector<Finding>& findings() const { return findings_; }

 private:
  std::vector<Finding> findings_;
};

/// Collects findings so that the user sees all of them at once.
class Findings {
 public:
  void add(Position where, std::string what);
  void add(const InputError& error);
  bool empty() const { return list_.empty(); }
  std::size_t size() const { return list_.size(); }
  /// Throws InputError with everything collected, in order of position, each once: what an alias repeats is one mistake.
  /// Does nothing when empty.
  void throw_if_any() const;

 private:
  std::vector<Finding> list_;
};

/// Results cannot be written (folder not writable, disk full). Says which file and why; exit code 4.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace dda
