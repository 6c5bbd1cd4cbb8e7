#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "continuation/increment/damped_motion.hpp"
#include "continuation/increment/load_solver.hpp"

namespace dda {
namespace {

struct DynamicRelaxationParameters {
  int max_iterations = 0;
};

/// Whether the kinetic energy falls from stop to stop, on the whole. On the way to an equilibrium it falls by
/// many orders within a hundred stops; of a structure that gives way, joint by joint, it does not.
class Decay {
 public:
  void stopped_at(double energy) {
    highest_ = std::max(highest_, energy);
    constexpr int many = 100;
    if (++stops_ < many) return;
    is_lacking_ = highest_ >= before_;
    before_ = std::exchange(highest_, 0.0);
    stops_ = 0;
  }
  bool is_lacking() const { return is_lacking_; }

 private:
  double before_ = std::numeric_limits<double>::infinity(), highest_ = 0;  ///< [FL]
  int stops_ = 0;
  bool is_lacking_ = false;
};

/// Dynamic relaxation with kinetic damping: explicit, without a factorisation.
///
/// It ends where the residual is that of an equilibrium. It fails where the structure gives way: the kinetic
/// energy does not decay, or the forces have done far more work than was stored at the start. It fails too
/// where the iterations do not suffice. Then nothing is accepted.
class DynamicRelaxation final : public LoadSolver {
 public:
  explicit DynamicRelaxation(const DynamicRelaxationParameters& p) : max_iterations_(p.max_iterations) {}

  std::string refusal(const Equilibrium& equilibrium) const override {
    if (equilibrium.num_unknown_multipliers() == 0) return {};
    return "'dynamic_relaxation' moves blocks and cannot find the unknown multipliers of 'lagrange'; use "
           "another treatment, or the solver 'newton'";
  }

  Found solve(System& system, const State& from, double load_factor,
              const StepperParameters& parameters) override {
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
    const double stored = system.stored(at, *system.laws_at(at.d, at.load_factor));
    const std::vector<double> force = forces(system, at.load_factor);
    const double before = dot(force, at.d);
    DampedMotion motion(*mass_, at.d);
    Decay decay;
    std::vector<double> residual(at.d.size());
    double relative = 0, work = 0;
    bool stopped = false;
    int iteration = 0;
    constexpr double far = 100;
    while (iteration < max_iterations_ && !decay.is_lacking() && (stored == 0 || work <= far * stored)) {
      ++iteration;
      system.residual(motion.d(), at.load_factor, system.laws(motion.d(), at.load_factor), residual);
      relative = system.relative(system.residual_norm(residual), motion.d());
      if (relative > tolerance && stopped)
        relative = system.excess_residual(residual, motion.d(), at.load_factor);
      if (relative <= tolerance) break;
      const double energy = motion.kinetic_energy();
      stopped = motion.move(residual);
      if (stopped) decay.stopped_at(energy);
      work = dot(force, motion.d()) - before;
    }
    found.relaxation_iterations += iteration;
    at.d = motion.d();
    if (relative <= tolerance) return true;
    found.why = fmt::format(
        "dynamic relaxation did not come to rest in {} iterations{} (relative residual {:.1e}; the forces "
        "did "
        "{:.1e} of work where {:.1e} was stored)",
        iteration, decay.is_lacking() ? ", its kinetic energy does not decay" : "", relative, work, stored);
    return false;
  }

  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }
  /// The forces under this load factor, without the far ends of driven springs.
  static std::vector<double> forces(const System& system, double load_factor) {
    std::vector<double> out = system.loading().dead_work;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += load_factor * system.loading().reference_work[i];
    return out;
  }

  /// Whether iterated multipliers are good; if not, their next values are in force.
  static bool close(System& system, State& at, double tolerance) {
    if (!system.iterates_multipliers()) return true;
    at.multipliers = system.multipliers();
    const auto laws = system.laws_at(at.d, at.load_factor);
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

std::unique_ptr<LoadSolver> make(const DynamicRelaxationParameters& p) {
  return std::make_unique<DynamicRelaxation>(p);
}

}  // namespace

DDA_REGISTER(load_solvers(), "dynamic_relaxation", schema(), make);

}  // namespace dda
