#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuation/course/point.hpp"
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

/// Where a followed stage has begun.
struct BegunStage {
  int number = 0;   ///< in the deck's `stages`, from 1
  double load = 0;  ///< where it begins: the curve has no row there

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("next", self.number);
    visit("next_load", self.load);
  }
};

/// A followed stage whose loads are held.
struct HeldStage {
  int number = 0;  ///< in the deck's `stages`, from 1
  int end = 0;     ///< step at which it ended
  double load_factor = 0, load = 0;
  int peak_step = 0;
  double peak_load = 0;
  BegunStage next = {};  ///< that comes after it
  std::string reason = {};

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("number", self.number);
    visit("end", self.end);
    visit("load_factor", self.load_factor);
    visit("load", self.load);
    visit("peak_step", self.peak_step);
    visit("peak_load", self.peak_load);
    BegunStage::visit(self.next, visit);
  }
};

/// What a run remembers beside its walker and path; a restart brings it back.
struct RunMemory {
  int last_step = 0;   ///< rows of the curve are those of steps 0 … last_step
  Measurement start;   ///< where the path begins
  Measurement peak;    ///< at the largest load so far of a stage
  int peak_stage = 0;  ///< how many stages were held then
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
  std::vector<HeldStage> stages;         ///< that are over
  std::optional<Ending> ended;           ///< how the path has ended, once it has

  /// The single numbers; what else there is has records of its own.
  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("last_step", self.last_step);
    visit("peak_stage", self.peak_stage);
    visit("is_peak_stored", self.is_peak_stored);
    visit("largest_gap", self.largest_gap);
    visit("first_stiffness", self.indicator.first_stiffness);
    visit("spare_modes", self.indicator.spare_modes);
  }
};

}  // namespace dda
