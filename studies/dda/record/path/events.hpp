#pragma once

#include <nlohmann/json.hpp>
#include <set>

#include "continuation/path/path.hpp"
#include "studies/dda/case/deck/event_kind.hpp"
#include "studies/dda/record/measures.hpp"

namespace dda {

/// Finds the limit points, turning points and bifurcations of a path from its points and their two tangents.
///
/// At a kink, where a quantity arrives rising and leaves falling, the extremum is the point itself. Inside a
/// smooth step it is that of the cubic through both ends and their tangents, in the dissipated energy; where
/// the tangents meet lies a bound, and the distance of the two is the uncertainty. A step across the highest
/// load was shortened by the path to bracket it. Points on their damage surface count as loading, so that a
/// bifurcation at a kink is the kink. Of an unsymmetric stiffness only an odd change of the number of
/// negative eigenvalues is one, where its determinant passes zero: two real eigenvalues may become complex.
class PathEvents {
 public:
  /// `known` are the events of the run that is continued.
  PathEvents(const Measures& measures, const Walker& start, int step, nlohmann::ordered_json known);

  /// Of a run that is continued the sizes of the quantities so far, which events are measured by.
  void remember_sizes(const CsvTable& curve);
  /// The loads are others from here on: what they do is no extremum of what those before did.
  void begin_stage(const Walker& walker);
  /// Events have this number as their `stage` from here on, and those before that had none; 0: they have none.
  void number_stages(int number);
  /// Adds what lies between the last point and this one, and tells what happens at it.
  std::set<EventKind> add(const Point& point, const Walker& walker, bool is_last);
  /// One object per event: kind, step, load, load_factor, dissipated_energy, gauges, …; in the order of the
  /// path. Those at the last row are pending (passed_events).
  const nlohmann::ordered_json& list() const { return list_; }

 private:
  /// A point with what arrives and leaves; [0] is the load, the others are the gauges.
  struct Station {
    int step = 0;
    std::vector<double> values, in, out;
    double load_factor = 0, load_factor_in = 0, load_factor_out = 0;
    double dissipated = 0;
    bool dissipates_in = false, dissipates_out = false;
    std::optional<int> num_negative, num_negative_work, surplus;
  };
  Station station(const Walker& walker, int step) const;
  void remember_sizes(const Station& at);
  bool find_extremum(std::size_t quantity, const Station& now, bool is_jump, bool is_last);
  bool find_bifurcation(const Station& now, const Point& point, bool is_last);
  bool is_smooth(const Station& now) const;
  /// The quantities in a share of the step that ends here.
  Station between(const Station& now, double share) const;
  void list_event(nlohmann::ordered_json event, const Station& at);
  nlohmann::ordered_json extremum(std::size_t quantity, bool is_maximum) const;

  const Measures& measures_;
  Station before_;
  int stage_ = 0;
  std::vector<double> largest_;  ///< magnitude of each quantity so far
  nlohmann::ordered_json list_;
};

/// The list without what is at its end, where it is not known how the path goes on; a run that is continued
/// takes it for events.
nlohmann::ordered_json passed_events(const nlohmann::ordered_json& list);

}  // namespace dda
