#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/dda/record/crack_record.hpp"
#include "studies/dda/record/failure_indicator.hpp"
#include "studies/dda/record/fields.hpp"
#include "studies/dda/record/measures.hpp"
#include "studies/dda/record/stiffness_record.hpp"

namespace dda {

/// Where and when an interface first spent energy; step −1 while it has not.
struct FirstCrack {
  int step = -1;
  Vec2 at = Vec2::Zero();

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("step", self.step);
    visit("at", self.at);
  }
};

/// What a run remembers beside its walker and path; a restart brings it back.
struct RunMemory {
  int last_step = 0;  ///< rows of the curve are those of steps 0 … last_step
  Measurement start;  ///< where the path of the last stage begins
  Measurement peak;   ///< at the largest load so far
  std::optional<StoredState>
      peak_state;  ///< fields of the peak; `is_peak_stored` says whether they are stored
  bool is_peak_stored = true;
  IndicatorMemory indicator;
  nlohmann::ordered_json events = nlohmann::ordered_json::array();  ///< located so far, see PathEvents
  StiffnessRecord stiffness = {};                                   ///< of the start, where it is asked for
  double largest_gap = 0;                ///< that iterated multipliers left in a step
  long long num_factorisations = 0;      ///< of the processes before this one
  std::vector<FirstCrack> first_cracks;  ///< by interface
  std::vector<GrownSegment> grown;       ///< of cracks through blocks, as they came

  /// The single numbers; what else there is has records of its own.
  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("last_step", self.last_step);
    visit("is_peak_stored", self.is_peak_stored);
    visit("largest_gap", self.largest_gap);
    visit("first_stiffness", self.indicator.first_stiffness);
    visit("spare_modes", self.indicator.spare_modes);
  }
};

}  // namespace dda
