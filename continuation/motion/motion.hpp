#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continuation/motion/ledger.hpp"
#include "continuation/motion/motion_step.hpp"

namespace dda {

/// How a motion goes on and where it ends.
struct MotionCourse {
  double time = 0;  ///< at most so long [T]
  bool stops_at_rest = true;
  double step = 0.01;  ///< in √(L/g), L the size of the smallest body that moves
  MotionTolerances tolerances = {};
};

/// A scene that moves: steps from one instant to the next, until a time or until rest.
class Motion {
 public:
  enum class Ending { none, at_rest, at_time, failed };

  /// Bodies start at `poses` with `velocities` ẏ.
  Motion(const MovingScene& scene, std::vector<Bond> bonds, Poses poses, Poses velocities,
         const MotionCourse& course);

  /// One step on; false at the end.
  bool advance();

  double time() const { return time_; }
  const Interval& step() const { return dt_; }
  const Poses& poses() const { return now_; }
  /// ẏ over the last step.
  Poses velocities() const;
  const std::vector<Bond>& bonds() const { return bonds_; }
  const MotionLedger& ledger() const { return ledger_; }
  int iterations() const { return iterations_; }
  int rejected() const { return rejected_; }
  Ending ending() const { return ending_; }
  const std::string& reason() const { return reason_; }
  const MeetingSearch& search() const { return *search_; }
  std::vector<Meeting> meetings() const { return potential_->meetings_anywhere(now_); }
  std::size_t num_meetings() const { return num_meetings_; }

 private:
  void release();
  bool has_left(const Bond& bond) const;
  Poses flown() const;
  void set_step();
  double longest() const;
  MotionLedger book(const MotionStep& step, const Poses& flight) const;
  bool creates_energy(const MotionLedger& step) const;
  void slide(const MotionStep& step);
  bool crack(const MotionStep& step);
  void accept(MotionStep step, const MotionLedger& book);
  void judge();

  const MovingScene& scene_;
  std::vector<Bond> bonds_;
  const MotionCourse course_;
  std::unique_ptr<MeetingSearch> search_;
  std::unique_ptr<Potential> potential_;
  std::unique_ptr<StepSolver> solver_;
  std::vector<MeetingSearch::Pair> joined_;  ///< that do not meet: by bonds, or not yet apart
  bool is_released_ = true;                  ///< all that is spent
  Poses before_, now_;
  Interval dt_;
  double time_ = 0, natural_ = 0;
  SliderMemory memory_;
  std::size_t num_meetings_ = 0;
  MotionLedger ledger_;
  int iterations_ = 0, rejected_ = 0, easy_ = 0, still_ = 0;
  bool slid_ = false, tears_ = false;
  double most_kinetic_ = 0;
  Ending ending_ = Ending::none;
  std::string reason_;
};

}  // namespace dda
