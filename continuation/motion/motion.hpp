#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "continuation/bodies/restitution.hpp"
#include "continuation/control/stop.hpp"
#include "continuation/integrator/integrator.hpp"
#include "continuation/motion/joined_bodies.hpp"
#include "continuation/motion/ledger.hpp"
#include "continuation/motion/step/step_solver.hpp"

namespace dda {

/// How a motion goes on and where it ends.
struct MotionCourse {
  double time = 0;  ///< at most so long [T]
  bool stops_at_rest = true;
  double step = 0.01;                   ///< in √(L/g), L the size of the smallest body that moves
  std::optional<double> accuracy = {};  ///< of places in a step, in sizes of their bodies; none: any
  std::shared_ptr<const Integrator> integrator = {};  ///< none: `free_flight`
  DampingRates damping = {};
  MotionTolerances tolerances = {};
};

/// The acceleration of all that moves by its loads; without loads v²/L of the fastest body [L/T²].
double pull_on(const MovingScene& scene, const Poses& velocities);
/// √(L/g) of a pull g, L the size of the smallest body that moves [T]; infinite where nothing pulls.
double pace_of(const MovingScene& scene, double pull);

/// What the next step of a motion depends on beside its scene.
struct MotionMemory {
  std::vector<BodyCourse> courses;
  std::vector<std::size_t> bonds;           ///< that are left, by their place in the list at the beginning
  std::vector<History> histories;           ///< of these
  std::vector<MeetingSearch::Pair> joined;  ///< that do not meet: by bonds, or not yet apart
  SliderMemory sliders;
  Interval dt;
  MotionLedger ledger;
  double time = 0, most_kinetic = 0;
  double overdrawn = 0;           ///< what contacts seem to have given that they had not taken [F L]
  std::vector<Vec6> holding;      ///< forces on what is held, by body [F, F L]
  std::vector<Vec6> meeting;      ///< the part of contacts of the forces on each body [F, F L]
  std::vector<RigidMotion> owed;  ///< what they have not had the energy for, by body; empty when nothing is
  int iterations = 0, rejected = 0, easy = 0, still = 0;
  bool is_released = true;  ///< all that is spent
  bool slid = false, tears = false;
};

/// A scene that moves: steps from one instant to the next, until a time or until rest.
class Motion {
 public:
  enum class Ending { none, at_rest, at_time, failed };

  /// Bodies start at `poses` with `velocities` ẏ.
  Motion(const MovingScene& scene, std::vector<Bond> bonds, Poses poses, Poses velocities,
         const MotionCourse& course);

  /// What contacts bear already at the beginning.
  void set_contacts(SliderMemory contacts) { m_.sliders = std::move(contacts); }

  /// Where an earlier motion of the same scene, bonds and beginning stood: it goes on with the same bits.
  void restore(MotionMemory memory, const std::vector<Bond>& bonds);
  MotionMemory memory() const;

  /// One step on; false at the end.
  bool advance();

  double time() const { return m_.time; }
  const Interval& step() const { return m_.dt; }
  const Poses& poses() const { return now_; }
  /// ẏ, as the integrator means it.
  Poses velocities() const;
  const std::vector<Bond>& bonds() const { return bonds_; }
  const MotionLedger& ledger() const { return m_.ledger; }
  int iterations() const { return m_.iterations; }
  int rejected() const { return m_.rejected; }
  Ending ending() const { return ending_; }
  const std::string& reason() const { return reason_; }
  /// Why it has failed; nothing where it has not.
  std::optional<Stop> stop() const { return stop_; }
  const MeetingSearch& search() const { return *search_; }
  std::vector<Meeting> meetings() const { return potential_->meetings_anywhere(now_); }
  std::size_t num_meetings() const { return num_meetings_; }

 private:
  struct Try;
  void release();
  void make_solver();
  void open_bonds();
  void begin_energies();
  void require_apart();
  bool has_left(const Bond& bond) const;
  std::vector<MeetingSearch::Pair> bearing_pairs() const;
  bool may_meet(const MeetingSearch::Pair& pair, const std::vector<MeetingSearch::Pair>& bearing) const;
  Inertia aim() const;
  void set_step();
  void land_on_kink();
  double longest() const;
  double longest_among_others(double dt) const;
  double bound_of_meeting(double dt) const;
  double travelled(std::size_t body, double turned) const;
  bool is_driven_on();
  Damping::Step damped(const Inertia& inertia) const;
  Try try_step();
  BodyStep step_of(std::size_t body, const Try& step, const AsOne& as_one) const;
  std::vector<AsOne> as_one(const Try& step) const;
  void book(Try& step) const;
  void book_fracture(const Poses& reached, MotionLedger& out) const;
  double done_by_contacts(std::size_t body, const Try& step, const BodyWork& work) const;
  StoredEnergies stored(const std::vector<BodyCourse>& at) const;
  bool creates_energy(const Try& tried) const;
  double error_of(const Try& step) const;
  /// A bond that a step has brought beyond its strength.
  struct Overload {
    std::size_t bond = 0;
    double beyond = 0;            ///< its opening there, of that at its strength
    Vec2 opening = Vec2::Zero();  ///< where it reached its strength [L]
  };
  std::vector<Overload> overloads(const Poses& reached) const;
  void lose_strength(const std::vector<Overload>& overloads);
  void take_back_strength();
  bool tears_unfelt(const Try& step) const;
  double shorter_step(const Try& step, bool is_overloaded) const;
  bool crack(const MotionStep& step);
  struct Encounter;
  Encounter encounter(const Try& step) const;
  void bounce(Try& step);
  void hold(Try& step, double energy);
  void calm(Try& step, const std::vector<std::size_t>& hit, const RigidGroups& groups) const;
  void push(Try& step, const std::vector<RigidMotion>& given);
  std::vector<MeetingSearch::Pair> held_together() const;
  void keep_forces(const Eigen::VectorXd& all, const Eigen::VectorXd& of_contacts);
  void accept(Try step);
  void judge();
  void end_if_due();

  const MovingScene& scene_;
  std::vector<Bond> bonds_;
  MotionCourse course_;
  std::unique_ptr<MeetingSearch> search_;
  std::unique_ptr<Potential> potential_;
  std::unique_ptr<StepSolver> solver_;
  MotionMemory m_;  ///< but for the histories, which are those of bonds_
  /// A bond that has lost its strength in this step.
  struct GivenUp {
    std::size_t bond = 0;
    History before;
    double energy = 0;  ///< that it has spent [F L]
  };
  std::vector<GivenUp> given_up_;
  JoinedBodies joined_;  ///< by bonds_
  Poses now_, start_;    ///< where bodies are, and where they were at first
  double natural_ = 0;
  double driven_at_ = 0;  ///< when what is driven moves on, as far as that has been looked for [T]
  double pull_ = 0;       ///< acceleration of all that moves, by the loads or by how fast it is [L/T²]
  std::size_t num_meetings_ = 0;
  Ending ending_ = Ending::none;
  std::string reason_;
  std::optional<Stop> stop_;
};

}  // namespace dda
