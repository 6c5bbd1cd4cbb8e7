#include "continuation/modules/loca/loca_steps.hpp"

#include <LOCA_Factory.H>
#include <LOCA_GlobalData.H>
#include <LOCA_MultiContinuation_AbstractStrategy.H>
#include <LOCA_MultiContinuation_ExtendedVector.H>
#include <LOCA_StepSize_AbstractStrategy.H>
#include <LOCA_Stepper.H>
#include <NOX_Solver_Generic.H>
#include <NOX_Utils.H>
#include <fmt/format.h>

#include <Teuchos_oblackholestream.hpp>
#include <stdexcept>

#include "continuation/modules/loca/group.hpp"
#include "continuation/modules/loca/parameter_list.hpp"
#include "continuation/modules/loca/status_test.hpp"
#include "continuation/modules/trilinos_session.hpp"
#include "continuation/solve/settling.hpp"

namespace dda {
namespace {

/// Step sizes come from the path's strategy; LOCA is given the one it asks for.
class GivenStep final : public LOCA::StepSize::AbstractStrategy {
 public:
  explicit GivenStep(double step) : step_(step) {}
  NOX::Abstract::Group::ReturnType computeStepSize(LOCA::MultiContinuation::AbstractStrategy&,
                                                   const LOCA::MultiContinuation::ExtendedVector&,
                                                   const NOX::Solver::Generic&,
                                                   const LOCA::Abstract::Iterator::StepStatus&,
                                                   const LOCA::Abstract::Iterator&, double& step) override {
    step = step_;
    return NOX::Abstract::Group::Ok;
  }
  double getPrevStepSize() const override { return step_; }
  double getStartStepSize() const override { return step_; }

 private:
  double step_;
};

/// LOCA's stepper, one step long: the caller decides whether a converged attempt is kept.
class SingleStep final : public LOCA::Stepper {
 public:
  SingleStep(const Teuchos::RCP<LOCA::GlobalData>& global, const Teuchos::RCP<Group>& start,
             const Teuchos::RCP<NewtonTest>& test, const Teuchos::RCP<Teuchos::ParameterList>& list,
             double step)
      : LOCA::Stepper(global, start, test, list), system_(start->system()), test_(test), wanted_(step) {
    stepSizeStrategyPtr = Teuchos::rcp(new GivenStep(step));
  }

  static constexpr auto singular = "the bordered system is singular";

  /// The step with Newton starting at `guess`, or at LOCA's prediction when null.
  Attempt take(const State* guess, const MultiplierParameters& multipliers) {
    Attempt out;
    try {
      take_step(guess, multipliers, out);
    } catch (const char*) {  // LOCA throws a singular bordered system through its stepper
      out.reason = singular;
    } catch (const std::logic_error&) {
      out.reason = singular;
    }
    out.converged = out.converged && out.reason.empty();
    return out;
  }

 private:
  void take_step(const State* guess, const MultiplierParameters& multipliers, Attempt& out) {
    if (start() != LOCA::Abstract::Iterator::NotFinished) {
      out.reason = "the start of the step is no equilibrium: " + test_->reason();
      return;
    }
    if (guess) {
      predict(*guess);
      if (multipliers.predicted) system_.set_multipliers(guess->multipliers);
    }
    preprocess(LOCA::Abstract::Iterator::Successful);
    out.converged = compute(LOCA::Abstract::Iterator::Successful) == LOCA::Abstract::Iterator::Successful;
    out.newton_iterations = solverPtr->getNumIterations();
    if (out.converged && system_.iterates_multipliers()) close_gaps(multipliers, out);
    out.residual = test_->relative_residual();
    if (!out.converged && out.reason.empty()) out.reason = test_->reason();
    out.state = equilibrium_group().state();
    out.state.multipliers = system_.multipliers();
  }

  const Group& equilibrium_group() const {
    return dynamic_cast<const Group&>(*curGroupPtr->getBaseLevelUnderlyingGroup());
  }

  /// Carries the springs' forces over into the multipliers and solves again until no gap is left.
  void close_gaps(const MultiplierParameters& parameters, Attempt& out) {
    Settling settling(parameters);
    for (;;) {
      const State at = equilibrium_group().state();
      const auto laws = system_.laws_at(at.d, at.load_factor);
      out.gap = system_.relative_gap(*laws);
      if (out.gap <= parameters.tolerance) return;
      if (out.multiplier_iterations >= parameters.max_iterations ||
          settling.is_out_of_reach(out.gap, system_.active_set(*laws))) {
        out.reason = fmt::format("the multipliers did not settle in {} iterations (relative gap {:.1e})",
                                 out.multiplier_iterations, out.gap);
        out.converged = false;
        return;
      }
      ++out.multiplier_iterations;
      system_.set_multipliers(system_.next_multipliers(*laws));
      solverPtr->reset(curGroupPtr->getX());
      out.converged = solverPtr->solve() == NOX::StatusTest::Converged;
      out.newton_iterations += solverPtr->getNumIterations();
      if (!out.converged) return;
      curGroupPtr->copy(solverPtr->getSolutionGroup());
    }
  }

  /// Makes LOCA's predictor direction point at the guess: x_start + step · direction = guess.
  void predict(const State& guess) {
    using Extended = LOCA::MultiContinuation::ExtendedVector;
    auto& constrained = dynamic_cast<Extended&>(*curPredictorPtr->getXVec());
    auto& direction = as_state(*constrained.getXVec());
    const Group& now = equilibrium_group();
    const auto from = now.displacement();
    const auto to = direction.local();
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = (guess.d[i] - from[i]) / wanted_;
    constrained.setScalar(0, (guess.load_factor - now.load_factor()) / wanted_);
    curPredictorPtr->setScalar(0, 1.0);
  }

  System& system_;
  Teuchos::RCP<NewtonTest> test_;
  double wanted_;
};

Teuchos::RCP<Teuchos::ParameterList> common_list(const std::string& method, const std::string& parameter,
                                                 double value, const StepperParameters& parameters) {
  auto list = Teuchos::rcp(new Teuchos::ParameterList);
  auto& nox = list->sublist("NOX");
  nox.set("Nonlinear Solver", "Line Search Based");
  nox.sublist("Line Search").set("Method", "Full Step");
  nox.sublist("Direction").set("Method", "Newton");
  const Teuchos::RCP<std::ostream> nowhere = Teuchos::rcp(new Teuchos::oblackholestream);
  nox.sublist("Printing").set("Output Information", 0);
  nox.sublist("Printing").set("Output Stream", nowhere);
  nox.sublist("Printing").set("Error Stream", nowhere);
  auto& stepper = list->sublist("LOCA").sublist("Stepper");
  stepper.set("Continuation Method", method);
  stepper.set("Continuation Parameter", parameter);
  stepper.set("Initial Value", value);
  stepper.set("Max Value", 1e300);
  stepper.set("Min Value", -1e300);
  stepper.set("Bordered Solver Method", "Bordering");
  stepper.set("Compute Eigenvalues", false);
  merge(parameters.nox, nox);
  merge(parameters.loca, list->sublist("LOCA"));
  return list;
}

Teuchos::RCP<const TpetraMap> map_of(const System& system) {
  return Teuchos::rcp(new TpetraMap(system.equilibrium().num_unknowns(), 0, all_ranks()));
}

struct Loca {
  Teuchos::RCP<LOCA::GlobalData> global;
  explicit Loca(const Teuchos::RCP<Teuchos::ParameterList>& list) : global(LOCA::createGlobalData(list)) {}
  ~Loca() { LOCA::destroyGlobalData(global); }
};

}  // namespace

Attempt loca_controlled_step(System& system, const StepGoal& goal, const StepperParameters& parameters) {
  const auto map = map_of(system);
  const auto active = std::make_shared<ActiveControl>(ActiveControl{&goal.control});
  const Teuchos::RCP<LOCA::MultiContinuation::ConstraintInterface> constraint =
      Teuchos::rcp(new ControlConstraint(system, map, active, goal.start));
  const auto list = common_list("Natural", "s", 0.0, parameters);
  auto& constraints = list->sublist("LOCA").sublist("Constraints");
  constraints.set("Constraint Object", constraint);
  constraints.set("Constraint Parameter Names", Teuchos::rcp(new std::vector<std::string>{"lambda"}));
  constraints.set("Bordered Solver Method", "Bordering");
  list->sublist("LOCA").sublist("Predictor").set("Method", "Constant");
  const Loca loca(list);
  const auto group = Teuchos::rcp(new Group(loca.global, system, map, goal.start, Metric::natural));
  const auto test = Teuchos::rcp(new NewtonTest(system, active, parameters.newton));
  return SingleStep(loca.global, group, test, list, goal.step).take(&goal.guess, parameters.multipliers);
}

Attempt loca_arc_length_step(System& system, const State& start, const ArcLength& arc,
                             const StepperParameters& parameters) {
  system.set_multipliers(start.multipliers);
  const auto list = common_list("Arc Length", "lambda", start.load_factor, parameters);
  auto& stepper = list->sublist("LOCA").sublist("Stepper");
  stepper.set("Enable Arc Length Scaling", true);
  stepper.set("Initial Scale Factor", arc.load_weight);
  stepper.set("Goal Arc Length Parameter Contribution", arc.goal);
  stepper.set("Max Arc Length Parameter Contribution", 1.0);
  stepper.set("Min Scale Factor", 0.0);
  list->sublist("LOCA").sublist("Predictor").set("Method", "Tangent");
  list->sublist("LOCA").sublist("Predictor").sublist("First Step Predictor").set("Method", "Tangent");
  const Loca loca(list);
  const auto group = Teuchos::rcp(new Group(loca.global, system, map_of(system), start, arc.metric));
  const auto test =
      Teuchos::rcp(new NewtonTest(system, std::make_shared<ActiveControl>(), parameters.newton));
  return SingleStep(loca.global, group, test, list, arc.length).take(nullptr, parameters.multipliers);
}

}  // namespace dda
