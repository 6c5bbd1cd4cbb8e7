#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "continuation/bodies/sliders.hpp"
#include "continuation/integrator/integrator.hpp"
#include "continuation/motion/energy/potential.hpp"

namespace dda {

/// How a step is solved.
struct MotionTolerances {
  double tolerance =
      1e-6;              ///< of what is left of the forces on a body, over the forces that act in the scene
  double loose = 0.003;  ///< the same, at which friction takes its bounds from the normal forces
  double friction_change = 0.01;  ///< of normal forces, between passes: all changes over all forces
  int most_passes = 100;
  int most_iterations = 100;  ///< of Newton's method, in a pass
};

/// Where a step begins.
struct StepStart {
  const Poses& poses;
  const std::vector<BodyCourse>& courses;  ///< that have led there
  const SliderMemory& sliders;             ///< what contacts keep of the last step
};

/// ½ c |y − ŷ|²_M; ŷ of held bodies is where they go.
struct Inertia {
  Poses flight;                ///< ŷ
  Poses likely;                ///< where the accelerations of the last step would lead
  double per_square_time = 0;  ///< c [1/T²]
};

/// The end of a step, or why there is none.
struct MotionStep {
  Poses poses;
  Eigen::VectorXd forces;   ///< ∂Π/∂y at the end, by body; of held bodies what it takes to hold them
  Eigen::VectorXd meeting;  ///< the part of contacts of them, friction included
  SliderMemory contacts;    ///< what those that are closed keep
  std::vector<Slide> slides;
  std::size_t num_meetings = 0;
  int iterations = 0;
  std::string failure;  ///< "" when it converged

  bool converged() const { return failure.empty(); }
};

/// Finds where a step of all bodies ends.
class StepSolver {
 public:
  virtual ~StepSolver() = default;
  virtual MotionStep solve(const StepStart& start, const Inertia& inertia) = 0;
  /// What is stored at the end of some courses, in the contacts of the step that was solved last [F L].
  virtual StoredEnergies stored(const std::vector<BodyCourse>& at) const = 0;
  /// Whether a step that gives back more energy than there was is a wrong one.
  virtual bool loses_energy() const { return true; }
  /// By what a step is shortened that was not found.
  virtual double cut() const { return 0.5; }
  /// The farthest that a corner may go in a step; 0: there is no such bound [L].
  virtual double longest_way() const { return 0; }
};

/// The largest force that the loads or, by a thousandth, inertia have on a body, moments over its size [F].
double force_scale(const MovingScene& scene, const Poses& start, const Inertia& inertia);

/// What is left of the forces on a body of a size, moments over it [F].
inline double left_of(const Vec6& forces, double size) {
  return std::max(forces.head<2>().norm(), forces.tail<4>().norm() / size);
}

/// What is left of some forces on each body, moments over its size, and which body it is most at.
struct Unbalanced {
  double force = 0;  ///< [F]
  std::size_t body = 0;
};
/// What rounding may leave of each, `rounding`, is taken off.
Unbalanced unbalanced(const MovingScene& scene, const Eigen::VectorXd& forces,
                      const std::vector<double>& rounding);

}  // namespace dda
