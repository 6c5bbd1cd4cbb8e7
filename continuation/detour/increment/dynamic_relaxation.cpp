#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "continuation/detour/increment/damped_motion.hpp"
#include "continuation/detour/increment/load_solver.hpp"

namespace dda {
namespace {

struct DynamicRelaxationParameters {
  int max_iterations = 0;
};

/// Dynamic relaxation with kinetic damping: explicit, without a factorisation.
///
/// It ends where the residual is that of an equilibrium; where the iterations do not suffice nothing is
/// accepted. A structure that gives way never comes to rest. One that is heading for an equilibrium may
/// flutter for a while at joints that open and close, so that neither energies nor their growth tell the two
/// apart before; what the kinetic energy did is reported.
class DynamicRelaxation final : public LoadSolver {
 public:
  explicit DynamicRelaxation(const DynamicRelaxationParameters& p) : max_iterations_(p.max_iterations) {}

  bool needs_tangents() const override { return false; }
  std::string refusal(const Equilibrium& equilibrium) const override {
    if (equilibrium.num_unknown_multipliers() == 0) return {};
    return "'dynamic_relaxation' moves blocks and cannot find the unknown multipliers of 'lagrange'; use "
           "another treatment, or the solver 'newton'";
  }

  Found solve(Stepper& stepper, const State& from, double load_factor) override {
    System& system = stepper.system();
    const StepperParameters& parameters = stepper.parameters();
    const auto scope = system.timings().measure("relaxation");
    if (of_ != &system.equilibrium()) {
      of_ = &system.equilibrium();
      mass_.emplace(of_->intact());
    }
    Found out;
    State at{from.d, load_factor, from.multipliers};
    for (int closing = 0; closing <= parameters.multipliers.max_iterations; ++closing) {
      if (!relax(system, at, parameters.newton.tolerance, out)) return out;
      if (!close(system, at, parameters.multipliers.tolerance)) continue;
      out.state = std::move(at);
      return out;
    }
    out.why = "the multipliers did not converge";
    return out;
  }

 private:
  /// Moves `at` to equilibrium; false when it does not come to rest, which `found` then explains.
  bool relax(System& system, State& at, double tolerance, Found& found) const {
    DampedMotion motion(*mass_, at.d);
    std::vector<double> residual(at.d.size());
    std::array<double, 2> highest{0, 0};  // kinetic energy in the first and in the second half [FL]
    double relative = 0;
    bool stopped = false;
    int iteration = 0;
    for (; iteration < max_iterations_ && std::isfinite(relative); ++iteration) {
      ++found.relaxation_iterations;
      system.residual(motion.d(), at.load_factor, system.laws(motion.d(), at.load_factor), residual);
      relative = system.relative(system.residual_norm(residual), motion.d());
      if (relative > tolerance && stopped)
        relative = system.excess_residual(residual, motion.d(), at.load_factor);
      if (relative <= tolerance) {
        at.d = motion.d();
        return true;
      }
      stopped = motion.move(residual);
      double& half = highest[2 * iteration < max_iterations_ ? 0 : 1];
      half = std::max(half, motion.kinetic_energy());
    }
    constexpr double decayed = 0.01;
    found.why = fmt::format(
        "dynamic relaxation did not come to rest in {} iterations (relative residual {:.1e}); its kinetic "
        "energy {}",
        iteration, relative, highest[1] < decayed * highest[0] ? "was still decaying" : "does not decay");
    return false;
  }

  /// Whether iterated multipliers are good; if not, their next values are in force.
  static bool close(System& system, State& at, double tolerance) {
    if (!system.iterates_multipliers()) return true;
    at.multipliers = system.multipliers();
    const auto laws = system.laws_at(at);
    if (system.relative_gap(*laws) <= tolerance) return true;
    system.set_multipliers(system.next_multipliers(*laws));
    return false;
  }

  int max_iterations_;
  const Equilibrium* of_ = nullptr;  ///< whose mass it is
  std::optional<FictitiousMass> mass_;
};

Schema<DynamicRelaxationParameters> schema() {
  return Schema<DynamicRelaxationParameters>(
             "Dynamic relaxation with kinetic damping and a fictitious mass: explicit, without a "
             "factorisation.")
      .integer("max_iterations", &DynamicRelaxationParameters::max_iterations,
               {.fallback = 20000,
                .bounds = at_least(1),
                .text = "Evaluations of the residual before an increment is given up."});
}

}  // namespace

DDA_REGISTER(load_solvers(), "dynamic_relaxation", schema(), make_of<DynamicRelaxation>);

}  // namespace dda
