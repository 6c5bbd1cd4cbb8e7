#pragma once

#include <string>

#include "continuation/motion/energy/positive_factor.hpp"
#include "continuation/motion/step/step_solver.hpp"

namespace dda {

/// One step: the minimum of
///
///     ½ c |y − ŷ|²_M + Π(y)
///
/// by Newton's method with an exact line search on what is free for cores to move, in passes. A pass takes the normal forces by
/// which friction is bounded from where it begins, and ends near its minimum: places on the way there tell nothing of forces
/// between stiff bodies. Where they have settled, the last pass finds the minimum; where they do not, there is no step.
/// Source of the principle: Li et al. (2020), Lan et al. (2022).
class StepMinimum final : public StepSolver {
 public:
  StepMinimum(const MovingScene& scene, Potential& potential, const MotionTolerances& tolerances)
      : scene_(scene), potential_(potential), tolerances_(tolerances) {}

  MotionStep solve(const StepStart& start, const Inertia& inertia) override;
  StoredEnergies stored(const std::vector<BodyCourse>& at) const override;

 private:
  struct Minimised {
    int iterations = 0;
    std::string failure = {};
  };
  Minimised minimise(Poses& z, const Inertia& inertia, double tolerance);
  Eigen::VectorXd gradient(const Poses& z, const Inertia& inertia) const;
  /// Slope along a direction where it begins, and the share of it that is free.
  struct Descent {
    double slope, free;
  };
  /// Where a line search has ended.
  struct Found {
    double share;
    Eigen::VectorXd gradient;
  };
  Found line_search(const Poses& z, const Poses& dz, const Inertia& inertia, const Descent& descent) const;
  double slope_along(const Eigen::VectorXd& gradient, const Poses& way) const;
  std::vector<Slider> sliders_at(const Poses& z, const SliderMemory& memory, bool uses_memory) const;
  void tell(const Poses& start, MotionStep& out) const;

  Poses predicted(const Poses& start, const Inertia& inertia);
  double objective(const Poses& z, const Inertia& inertia) const;
  Poses ways_of_held(const Poses& z, const Inertia& inertia) const;
  Poses direction(const Poses& z, const Inertia& inertia, const Eigen::VectorXd& gradient);
  double bearable_share(const Poses& dz) const;
  bool factor(const Potential::Curvature& curvature);

  const MovingScene& scene_;
  Potential& potential_;
  MotionTolerances tolerances_;
  double scale_ = 0;              ///< of forces [F]
  std::vector<double> rounding_;  ///< of those on each body [F]
  PositiveFactor factor_;
  bool is_analysed_ = false;
};

}  // namespace dda
