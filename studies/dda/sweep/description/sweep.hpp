#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/deck/changes/axes.hpp"
#include "framework/deck/units.hpp"
#include "studies/dda/sweep/description/derived_columns.hpp"

namespace dda {

/// One run of a sweep.
struct SweepCase {
  std::filesystem::path deck;          ///< from the current folder
  std::vector<Node> values;            ///< of the varied keys, in the order of Sweep::keys
  std::vector<std::string> overrides;  ///< what `dda run` of the deck is given by --set
  std::vector<std::string> seeds;      ///< paths that the key `seed` stands for
  /// Of each derived column the numbers that its deck and settings know.
  std::vector<std::vector<std::optional<double>>> known;
  std::string effective;  ///< every parameter, as YAML: equal for equal runs
};

/// A sweep as its file describes it: the axes and every case of their product, each read and found valid.
struct Sweep {
  std::filesystem::path file;
  std::string text;                    ///< of the file
  std::vector<std::string> overrides;  ///< --set, of the sweep as a whole
  std::string title;
  Units units;  ///< of the first case
  std::vector<Axis> axes;
  std::vector<std::string> key_units;  ///< of the varied keys, "" = none
  std::vector<DerivedColumn> derived;  ///< columns of sweep.csv that are computed of others
  std::vector<SweepCase> cases;

  /// The varied keys, axis by axis.
  std::vector<SweptKey> keys() const;
};

/// Whether a file's tree has a `sweep` section, after the overrides.
bool is_sweep(const Node& root, const std::vector<std::string>& overrides);

/// Reads a sweep file and the decks of all cases; overrides of `sweep.…` belong to the section, others to
/// each deck. Nothing is meshed. Throws InputError with every finding, at the entries of the sweep file.
Sweep read_sweep(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// "depth=50": the value of a varied key, by the shortest end of its name that no other one shares.
std::string setting_text(const Sweep& sweep, const SweepCase& one, std::size_t key);

/// "depth=50, seed=3": all of them.
std::string settings_text(const Sweep& sweep, const SweepCase& one);

}  // namespace dda
