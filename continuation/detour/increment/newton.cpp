#include "continuation/detour/increment/load_solver.hpp"
#include "continuation/solve/held_equilibrium.hpp"

namespace dda {
namespace {

/// Newton's method with the load factor held; factorises the tangent.
class NewtonAtLoad final : public LoadSolver {
 public:
  Found solve(Stepper& stepper, const State& from, double load_factor) override {
    const Functional load{.rows = {}, .per_load_factor = 1};
    HeldEquilibrium equilibrium(stepper, load, load_factor);
    Found out;
    out.state = equilibrium.solve(from);
    out.newton_iterations = equilibrium.iterations();
    if (!out.state) out.why = "Newton's method found no equilibrium";
    return out;
  }
};

Schema<NoParameters> schema() {
  return Schema<NoParameters>("Newton's method, with `path.newton` and `path.linear`.");
}

}  // namespace

DDA_REGISTER(load_solvers(), "newton", schema(), make_of<NewtonAtLoad>);

}  // namespace dda
