#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continuation/course/path_parameters.hpp"
#include "continuation/handover/motion_parameters.hpp"
#include "framework/deck/units.hpp"
#include "meshing/scene/scene.hpp"
#include "models/parameters.hpp"
#include "studies/dda/case/deck/event_kind.hpp"
#include "studies/dda/case/deck/lists/listed_keys.hpp"

namespace dda {

/// The M of K φ = μ M φ: identities, that of density 1, or that of the materials.
enum class EigenvalueMass { none, unit, density };

/// Eigenvalues of the tangent stiffness that a deck asks for.
struct EigenvalueParameters {
  int count = 0;              ///< lowest eigenvalues per step; 0: none
  int every = 1;              ///< steps between them; 0: only at the events
  std::vector<EventKind> at;  ///< events at which they are computed as well
  EigenvalueMass mass = EigenvalueMass::unit;
  Position where;
};

/// A peak load known from elsewhere, against which that of the run is reported.
struct ReferencePeak {
  double load = 0;                   ///< [F]
  std::string text;                  ///< what it is and where it comes from
  std::map<std::string, double> at;  ///< values of gauges there, for the figures
};

/// A rectangle of the structure, by two opposite corners [L].
struct Detail {
  Spot from, to;
};

/// The deck's `record` section: what is kept beside the curve.
struct RecordParameters {
  static constexpr std::size_t most_stiffness_blocks = 10;  ///< that can be read on paper

  int fields_every = 10;
  std::map<std::string, std::vector<double>> at;
  std::string folder;
  bool condition = false;
  bool stiffness = false;
  EigenvalueParameters eigenvalues;
  std::optional<ReferencePeak> reference_peak;
  std::optional<Detail> detail;
};

/// A whole deck.
struct Deck : ModelParameters {
  std::string title;
  Units units;
  Scene scene;
  PathParameters path;
  std::optional<MotionParameters> motion;
  RecordParameters record;
  std::optional<Node>
      sweep;  ///< of a file that describes many runs, see studies/dda/sweep/description/sweep.hpp; none in one run
  ListedKeys listed;  ///< by NOX's and LOCA's lists

  /// Without loads there is nothing to follow, only a motion.
  bool has_path() const { return !stages.empty(); }
  /// Whether what is left in the end is let go.
  bool moves() const { return motion && path.then != AfterPath::end; }
};

/// The one declaration of a deck: reading, explain, JSON schema and effective deck come from it.
const Schema<Deck>& deck_schema();

/// A file with a deck or a sweep: its text, and the tree of the text.
struct DeckSource {
  std::filesystem::path path;
  std::string text;
  Node root;
};

/// Throws InputError when the file cannot be read or is no YAML.
DeckSource read_source(const std::filesystem::path& path);

/// A deck as read: its text, its tree with overrides, and its values.
struct DeckFile {
  std::filesystem::path path;
  std::string text;
  std::vector<std::string> overrides;
  Deck deck;
};

/// Reads, overrides and validates a deck. Throws InputError with every finding.
DeckFile read_deck(DeckSource source, const std::vector<std::string>& overrides);
DeckFile read_deck(const std::filesystem::path& path, const std::vector<std::string>& overrides);

/// The same for a deck held as text; `path` is what positions say and where relative file names start.
DeckFile deck_from_text(const std::string& text, const std::filesystem::path& path,
                        const std::vector<std::string>& overrides);

/// The deck with every default, below a comment that names the program's version and the overrides.
std::string effective_deck(const DeckFile& file);

}  // namespace dda
