#pragma once

#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continuation/detour/release.hpp"
#include "continuation/path/path_parameters.hpp"
#include "continuation/state/standstill.hpp"
#include "continuation/walk/walker.hpp"

namespace dda {

/// A value of a gauge on which a step is to end exactly.
struct Landing {
  std::string name;  ///< of the gauge
  Functional gauge;
  double value = 0;
  bool ends_leg = false;
  bool only_falling = false;  ///< counts only when passed downwards
};

/// Share of a value, or of the way to it, by which a gauge may be off and is taken to stand on it.
inline constexpr double same_value = 1e-7;

/// Turns of a displacement gauge that are deeper than this share of its largest value are seen in the rows of
/// the path, whatever the size of the steps.
inline constexpr double turn_depth = 0.005;

/// A part of the path under the loads of its last stage: followed by the control, or unloaded.
struct Leg {
  std::string name;
  bool unloads = false;        ///< leaves the damage surfaces and goes straight to `until`
  std::vector<Landing> until;  ///< the next leg begins at the first of them
};

/// How far a gauge has come since the leg began.
struct Travel {
  double from = 0;      ///< its value then
  double farthest = 0;  ///< the value farthest from it so far
};

/// An accepted point of the path.
struct Point {
  int step = 0;
  std::string control;
  int newton_iterations = 0;
  double residual = 0;  ///< of equilibrium, relative to the force level
  int multiplier_iterations = 0;
  double gap = 0;                   ///< relative, that iterated multipliers leave
  double jump_energy = 0;           ///< released on the way here where no equilibrium path led [FL]
  std::vector<std::string> landed;  ///< "cmod=0.1", "peak?" …: why fields should be kept here
  bool is_highest = false;          ///< the largest load so far
  /// Negative eigenvalues of the stiffness, every point on its damage surface loading: 0 where the
  /// equilibrium is stable under dead load. Nothing where an unsymmetric stiffness does not tell
  /// (unsymmetric_inertia.hpp).
  std::optional<int> num_negative;
  /// Motions whose second-order work is negative, dᵀ K d < 0; of a symmetric stiffness the same number.
  std::optional<int> num_negative_work;
  /// Those that are left under the control: 0 where it is stable if what the control prescribes is held.
  std::optional<int> num_negative_under_control;
  bool switched = false;  ///< the path leaves it by another branch than it would by itself
};

/// Why and how a path ended.
struct Ending {
  enum class Kind { running, goal_reached, stopped_early, interrupted };
  Kind kind = Kind::running;
  std::string reason;
};

/// What the path remembers beside the walker; a restart brings it back.
struct PathMemory {
  double peak_load = 0;      ///< largest load so far, in the direction of the first loading
  int direction = 0;         ///< sign of the load gauge in the first loading; 0 before it
  double step = 0;           ///< size of the next step in the control's quantity; 0 = choose
  std::string step_control;  ///< the control that size belongs to
  double largest_displacement = 0;
  double jump_energy = 0;
  double last_quantum = 0;   ///< energy dissipated by the last good step
  double unaccounted = 0;    ///< Σ |work − storage − dissipation| of the single steps [FL]
  double control = 0;        ///< what the control remembers
  int leg = 0;               ///< which leg is being followed
  int leg_start = 0;         ///< accepted steps before it
  int surplus = 0;           ///< negative eigenvalues with which a branch may be left (Candidate::surplus)
  double leg_peak = 0;       ///< largest load since the leg began
  double largest_force = 0;  ///< Σ |force| of loads and driven springs, largest so far [F]
  double imbalance = 0;      ///< work − storage − dissipation, jumps left out [FL]
  std::map<std::string, Travel> travels;  ///< of all gauges, and of the load as `load`
  int idle_looks = 0;                     ///< looks for a hidden peak, one after another, that found none
  int idle_turn_looks = 0;                ///< and for hidden turns of gauges
  bool has_slid = false;                  ///< a contact has changed since the start
  bool is_mechanism = false;              ///< the load has stayed while the structure moved
};

/// The equilibrium path of the last stage as a range: `for (const Point& p : path)`.
///
/// Common to every control: the first crack is located by the event control; steps are sized by how well the
/// tangent predicted the last one; a step across the limit point is shortened until the peak is bracketed;
/// steps land on wanted gauge values; a converged step that no continuous path explains (its energies do not
/// balance), or that retraces the unloading branch, is rejected; where Newton fails at the smallest step,
/// sequentially linear steps carry on; points whose law loses its strength at once are released event by
/// event (release.hpp). The path may have several legs: loading, unloading to a gauge value, loading again.
/// The walker must stand at the start of the stage.
class Path {
 public:
  Path(Walker& walker, const PathParameters& parameters, const GaugeBook& gauges,
       std::vector<Landing> landings, std::vector<Leg> legs = {Leg{}});

  /// The next accepted point, or nothing at the end; then `ending()` says why.
  std::optional<Point> next();
  const Ending& ending() const { return ending_; }
  PathMemory memory() const;
  void restore(const PathMemory& memory);
  /// Called before each attempt; true ends the path as interrupted.
  void interrupt_when(std::function<bool()> asked) { interrupted_ = std::move(asked); }
  /// Told about every rejected attempt and rescue, for the log.
  void report_to(std::function<void(const std::string& event, const std::string& text)> listener) {
    report_ = std::move(listener);
  }
  /// The load gauge of the path.
  const Functional& load_gauge() const { return load_; }
  /// How much of its way the gauge has gone that is nearest to a value which ends the path; 0 without any.
  double share_of_goals() const;
  /// Stability of the equilibrium at which the walker stands.
  void judge(Point& point) const;

  class Iterator {
   public:
    using iterator_concept = std::input_iterator_tag;
    using difference_type = std::ptrdiff_t;
    using value_type = Point;
    explicit Iterator(Path* path) : path_(path) { ++*this; }
    const Point& operator*() const { return *point_; }
    Iterator& operator++() {
      point_ = path_->next();
      return *this;
    }
    void operator++(int) { ++*this; }
    friend bool operator==(const Iterator& it, std::default_sentinel_t) { return !it.point_; }

   private:
    Path* path_;
    std::optional<Point> point_;
  };
  Iterator begin() { return Iterator(this); }
  std::default_sentinel_t end() const { return {}; }

 private:
  // One step.
  std::optional<Point> take_step();
  std::optional<Point> event_step();
  std::optional<Point> linear_step();
  std::optional<Point> sliding_step();
  std::optional<Point> first_slip(double change);
  std::optional<Point> linear_for_good();
  Move sliding_move();
  double amount_to_landing() const;
  bool moves_freely() const;
  double standing_load(double load) const;
  void note_mechanism(Point& point, const State& before);
  double amount_to_event() const;
  bool can_slide() const;
  std::optional<Point> controlled_step(const Move& move);
  std::optional<Point> sequential_step(const std::string& control, double quantum);
  std::optional<Point> release_step();
  std::optional<Point> release_holding(const Functional* held);
  std::optional<Point> release_by_jump();
  std::optional<Point> driven_step();
  std::optional<Point> end_without_equilibrium(const std::string& why);
  bool turns_load_round(const ReleasedPiece& piece) const;
  std::optional<Point> increment_step();
  std::optional<Point> unload_step();
  std::optional<Point> jump_to(Candidate beyond, const std::string& control);
  std::optional<Point> land_ahead(double amount, bool slides = false);
  std::optional<Point> approach(double amount);
  /// What the try of a step before has left unaccounted for.
  struct Snap {
    double natural = 0;  ///< size of the first try
    double amount = 0;   ///< of the one before; 0 when there was none
    double lost = 0;     ///< by it [FL]
  };
  std::optional<Point> snap(const Candidate& beyond, const Move& move, double amount, Snap& snap);
  std::optional<Point> land_on_turn(double failed, bool on_new_cracks, const Move& move);
  bool creates_energy(const Candidate& beyond) const;
  std::optional<Candidate> try_step(const Move& move, double amount, std::string& why,
                                    Thoroughness thoroughness = Thoroughness::usual);
  Attempt attempt(const Move& move, double amount, Thoroughness thoroughness);
  std::optional<Candidate> judged(const Attempt& tried, const std::string& control, std::string& why);
  bool lies_behind(const Candidate& candidate, const Move& move) const;
  void reject(const std::string& control, const std::string& why);
  std::string objection(const Candidate& candidate) const;
  bool loses_work(const Candidate& candidate, double most) const;
  double missing_work(const Candidate& candidate) const;
  std::string unsoundness(const Candidate& candidate) const;
  std::string energy_objection(const Candidate& candidate) const;
  std::optional<Point> end_of_sound(std::string reason);
  bool only_touches(const Candidate& candidate) const;
  bool is_coarse(const Candidate& candidate) const;

  // Refinements of a converged step.
  std::optional<double> before_peak(const Candidate& candidate) const;
  std::optional<double> before_turn(const Candidate& candidate) const;
  std::optional<double> before_hidden_turn(const Candidate& candidate, double amount) const;
  bool may_hide_peak(const Candidate& candidate) const;
  bool turns(const Candidate& candidate) const;
  bool may_hide_turns(const Candidate& candidate) const;
  double size_of_gauge(const NamedGauge& gauge, const Candidate& candidate) const;
  /// What a step has been taken in parts for.
  struct Looks {
    bool for_peak = false, for_turn = false;
  };
  void note_looks(const Looks& looks, const Candidate& candidate);
  struct Crossing {
    Landing landing;
    double share;
  };
  std::optional<Point> release_up_to(const Crossing& crossing, const Functional* held, double most);
  std::optional<Crossing> first_crossing(const Candidate& candidate) const;
  std::optional<Point> land(const Candidate& beyond, const Crossing& crossing, const std::string& control);
  std::optional<Point> land_on_strength(const Candidate& beyond, const std::string& control);
  double share_to_strength(const Candidate& candidate) const;
  std::optional<Point> rupture();
  std::string turning_point();
  bool is_mechanism(const State& state) const;

  // Branches.
  std::optional<Candidate> first_unstable(const Candidate& beyond, double amount, const Move& move);
  void choose_branch(Point& point);

  // Sizes and ends.
  double first_amount() const;
  double unit_of(const Move& move) const;
  double sliding_amount() const;
  double bounded(double amount) const;
  void resize(const Candidate& candidate, double amount, const Move& move);
  Point keep(Candidate candidate, const std::string& control);
  std::vector<Landing> present_landings() const;
  void settle();
  std::string goal_of_path() const;
  std::string reached(const Landing& goal) const;
  bool has_ruptured() const;
  void set_out();
  void note_travel();
  void look_for_standstill(const Point& point);
  void report_passed(const State& from, const State& to) const;
  const Leg& leg() const { return legs_[static_cast<std::size_t>(memory_.leg)]; }
  bool is_last_leg() const { return static_cast<std::size_t>(memory_.leg) + 1 == legs_.size(); }
  void begin_next_leg();
  std::optional<Point> end(Ending::Kind kind, std::string reason);
  double load_of(const State& state) const;
  double smallest_load() const;
  double displacement_of(const State& state) const;
  double displacement_rate(const Tangent& tangent) const;
  void report(const std::string& event, const std::string& text) const {
    if (report_) report_(event, text);
  }

  Walker& walker_;
  const PathParameters& parameters_;
  std::unique_ptr<Control> control_;
  Functional load_;
  Functional displacement_;  ///< on which the load works
  std::vector<Landing> landings_;
  std::vector<Leg> legs_;
  std::vector<NamedGauge> travelling_;  ///< whose travel is remembered
  bool releases_at_once_ = false;       ///< some law does
  double size_ = 0;                     ///< of the structure [L]
  Standstill standstill_;
  mutable std::string unsound_;  ///< what the last candidate of this step was refused for, beside equilibrium
  std::optional<Candidate> jumped_;  ///< an equilibrium that the last try found, refused as a jump
  PathMemory memory_;
  Ending ending_;
  std::function<bool()> interrupted_;
  std::function<void(const std::string&, const std::string&)> report_;
};

}  // namespace dda
