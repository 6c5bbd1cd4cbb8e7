#pragma once

#include "continuation/bodies/entrances.hpp"
#include "continuation/motion/energy/first_order.hpp"
#include "continuation/motion/energy/positive_factor.hpp"
#include "continuation/motion/step/step_solver.hpp"

namespace dda {

/// A contact of a step that opens and closes. Its place is that of the step's beginning:
///
///     N = −k g where it is closed,   g = g₀ + n · (way of the corner − way of the foot)
///     T = k_t u where it sticks,     u = e + t · (the same),      t = n turned by 90°
///     T = ± μ N where it slides,     N that of the pass before
///
/// A contact that slides back sticks again, from the stretch k_t u = ± μ N on that friction bears by then.
struct OpenCloseContact {
  enum class State { open, sticks, slides };

  Slider slider;        ///< where it is; e, k_t and the bound μ N of the last pass
  double friction = 0;  ///< μ
  State state = State::open;
  double side = 0;     ///< ± 1, the sign of u where it slides
  double reached = 0;  ///< μ N after the pass
  double hardly = 0;   ///< a gap or overlap that changes nothing: rounding would open and close for ever [L]

  double stiffness() const { return slider.meeting.stiffness; }
  /// g and u after some ways.
  double gap(const Poses& ways) const;
  double slip(const Poses& ways) const;
  /// What it pushes the corner with, along n (N) and against t.
  double normal_force(const Poses& ways) const;
  double shear_force(const Poses& ways) const;
  /// The state that the result of a pass asks for. Whether it is another one.
  bool change(const Poses& ways);
  /// u of the next step, and what friction has spent on the way to it [F L].
  double kept(const Poses& ways) const;
  double spent(const Poses& ways) const;
};

/// A step of discontinuous deformation analysis: linear systems
///
///     M c (z − z_f) + f + K z + contacts(z) = 0         z ways in first order, z_f that of inertia
///
/// one after another, after each of which contacts open, close, stick or slip, until none changes. Not found is a step
/// whose contacts go on to change, or in which a corner goes farther than it may. Where there are bonds, systems with
/// their secants follow each other for the same contacts until forces balance.
///
/// What it misses is no error of solving: overlaps by the penalties, ways of second order, N of the pass before. It is
/// all in the numerical part of the energy book. Source: Shi (1988).
class OpenCloseStep final : public StepSolver {
 public:
  /// What it stands on.
  struct Of {
    const MovingScene& scene;
    const MeetingSearch& search;
    const std::vector<Bond>& bonds;
    Potential& potential;  ///< without meetings
  };
  OpenCloseStep(const Of& of, const Integrator& integrator, const MotionTolerances& tolerances);

  MotionStep solve(const StepStart& start, const Inertia& inertia) override;
  StoredEnergies stored(const std::vector<BodyCourse>& at) const override;
  bool loses_energy() const override { return false; }
  double cut() const override { return 0.3; }
  double longest_way() const override { return longest_way_; }

 private:
  using Vector = Eigen::VectorXd;

  void begin(const StepStart& start, const Inertia& inertia);
  OpenCloseContact contact_at(const Meeting& meeting, const SliderMemory& memory) const;
  std::string balance(const Inertia& inertia, int& iterations);
  Vector contact_forces() const;
  Vector residual(const Inertia& inertia) const;
  bool factor(double per_square_time);
  bool change_states();
  double farthest_way(const Poses& reached) const;
  void tell(MotionStep& out) const;

  Of of_;
  const Integrator& integrator_;
  const OpenCloseRules& rules_;
  MotionTolerances tolerances_;
  EntranceSearch entrances_;
  FirstOrder first_order_;
  double longest_way_;     ///< of a corner in a step [L]
  std::vector<int> rows_;  ///< of bodies in what moves
  Poses start_, ways_;
  Poses flight_;  ///< z_f
  std::vector<OpenCloseContact> contacts_;
  double scale_ = 0;              ///< of forces [F]
  std::vector<double> rounding_;  ///< of those on each body [F]
  BlockSum sum_;
  PositiveFactor factor_;
};

}  // namespace dda
