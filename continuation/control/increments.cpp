#include <algorithm>
#include <cmath>

#include "continuation/control/control.hpp"

namespace dda {
namespace {

struct IncrementParameters {
  double increment = 0.05;
  LoadSolverChoice solver;
};

/// Load increments as Pearce et al. (2000) used them: the path releases everything that an increment brings
/// beyond its strength, and halves increments that find no equilibrium. For comparison with exact events.
class LoadIncrements final : public Control {
 public:
  explicit LoadIncrements(const IncrementParameters& p) : increment_(p.increment), solver_(p.solver.make()) {}

  Move next(Walker& walker) override { return event_move(walker); }
  double load_increment() const override { return increment_; }
  double prescribed_rate(const Tangent& along) const override { return along.load_factor; }
  bool sizes_steps() const override { return false; }
  LoadSolver* load_solver() override { return solver_.get(); }
  std::string refusal(const Equilibrium& equilibrium) const override {
    const auto& points = equilibrium.interfaces().points;
    const auto has_strength = [](const InterfacePoint& p) {
      return std::isfinite(p.law->initial_kappa(p.stiffness));
    };
    if (std::ranges::any_of(points, &InterfacePoint::is_separate) &&
        std::ranges::none_of(points, has_strength))
      return "'load_increments' releases what is beyond its strength, and joints that only touch have none; "
             "use `staged`, which follows what slides and opens";
    return solver_->refusal(equilibrium);
  }

 private:
  double increment_;
  std::unique_ptr<LoadSolver> solver_;
};

Schema<IncrementParameters> schema() {
  return Schema<IncrementParameters>(
             "Load increments, halved near failure; what is beyond its strength is released at once "
             "(mohr_coulomb).")
      .number("increment", &IncrementParameters::increment,
              {.fallback = 0.05,
               .bounds = above(0) & at_most(1),
               .text = "First size of an increment in units of the load at the first crack."})
      .choice("solver", &IncrementParameters::solver, load_solvers(),
              {.fallback = "newton", .text = "What finds the equilibrium of an increment."});
}

}  // namespace

DDA_REGISTER(controls(), "load_increments", schema(), make_of<LoadIncrements>);

}  // namespace dda
