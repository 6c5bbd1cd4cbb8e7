#include <LOCA_Abstract_Factory.H>
#include <LOCA_Factory.H>
#include <LOCA_GlobalData.H>
#include <LOCA_MultiContinuation_AbstractStrategy.H>
#include <LOCA_StepSize_AbstractStrategy.H>
#include <LOCA_Stepper.H>
#include <NOX_Solver_Generic.H>

#include <Teuchos_oblackholestream.hpp>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "continuation/modules/loca/control_constraint.hpp"
#include "continuation/modules/loca/dense_vector.hpp"
#include "continuation/modules/loca/equations_merit.hpp"
#include "continuation/modules/loca/extended.hpp"
#include "continuation/modules/loca/group.hpp"
#include "continuation/modules/loca/status_test.hpp"
#include "continuation/modules/loca/walk_direction.hpp"
#include "framework/base/loaded.hpp"

namespace dda {
namespace {

/// Steps are as long as the path asks for.
class PathStepSize final : public LOCA::StepSize::AbstractStrategy {
 public:
  explicit PathStepSize(std::shared_ptr<const ActiveSolve> active) : active_(std::move(active)) {}
  NOX::Abstract::Group::ReturnType computeStepSize(LOCA::MultiContinuation::AbstractStrategy&,
                                                   const LOCA::MultiContinuation::ExtendedVector&,
                                                   const NOX::Solver::Generic&,
                                                   const LOCA::Abstract::Iterator::StepStatus&,
                                                   const LOCA::Abstract::Iterator&, double& step) override {
    before_ = step = active_->step;
    return NOX::Abstract::Group::Ok;
  }
  double getPrevStepSize() const override { return before_; }
  double getStartStepSize() const override { return active_->step; }

 private:
  std::shared_ptr<const ActiveSolve> active_;
  double before_ = 0;
};

/// What LOCA's factories ask for by the name "path".
class PathStrategies final : public LOCA::Abstract::Factory {
 public:
  explicit PathStrategies(std::shared_ptr<const ActiveSolve> active) : active_(std::move(active)) {}
  void init(const Teuchos::RCP<LOCA::GlobalData>&) override {}
  bool createStepSizeStrategy(const std::string& name, const Teuchos::RCP<LOCA::Parameter::SublistParser>&,
                              const Teuchos::RCP<Teuchos::ParameterList>&,
                              Teuchos::RCP<LOCA::StepSize::AbstractStrategy>& strategy) override {
    if (name != "path") return false;
    strategy = Teuchos::rcp(new PathStepSize(active_));
    return true;
  }

 private:
  std::shared_ptr<const ActiveSolve> active_;
};

/// What NOX and LOCA print goes into a file, or nowhere.
Teuchos::RCP<std::ostream> stream_of(const LocaSettings& settings) {
  if (settings.output == 0 || settings.log.empty()) return Teuchos::rcp(new Teuchos::oblackholestream);
  return Teuchos::rcp(new std::ofstream(settings.log, std::ios::app));
}

Teuchos::RCP<Teuchos::ParameterList> list_of(const LocaSettings& settings,
                                             const std::shared_ptr<const ActiveSolve>& active) {
  auto list = Teuchos::rcp(new Teuchos::ParameterList);
  auto& nox = list->sublist("NOX");
  nox.set("Nonlinear Solver", "Line Search Based");
  nox.sublist("Line Search").set("Method", settings.line_search);
  const Teuchos::RCP<NOX::Direction::UserDefinedFactory> walks =
      Teuchos::rcp(new WalkDirectionFactory(active));
  nox.sublist("Direction").set("Method", "Newton");
  nox.sublist("Direction").set("User Defined Direction Factory", walks);
  const Teuchos::RCP<NOX::MeritFunction::Generic> merit = Teuchos::rcp(new EquationsMerit(active));
  nox.sublist("Solver Options").set("User Defined Merit Function", merit);
  nox.sublist("Line Search").sublist("Backtrack").set("Max Iters", 8);
  const Teuchos::RCP<std::ostream> stream = stream_of(settings);
  nox.sublist("Printing").set("Output Information", settings.output);
  nox.sublist("Printing").set("Output Stream", stream);
  nox.sublist("Printing").set("Error Stream", stream);
  auto& loca = list->sublist("LOCA");
  auto& stepper = loca.sublist("Stepper");
  stepper.set("Continuation Method", "Natural");
  stepper.set("Continuation Parameter", "s");
  stepper.set("Initial Value", 0.0);
  stepper.set("Max Value", 1e300);
  stepper.set("Min Value", -1e300);
  stepper.set("Bordered Solver Method", "Bordering");
  stepper.set("Compute Eigenvalues", false);
  loca.sublist("Step Size").set("Method", "path");
  loca.sublist("Predictor").set("Method", "Constant");
  loca.sublist("Constraints").set("Bordered Solver Method", "Bordering");
  return list;
}

/// The unknowns of the whole structure are a Tpetra vector, which is loaded with the rest of Trilinos.
Teuchos::RCP<NOX::Abstract::Vector> vector_of(const Equations& equations, const Iterate& at) {
  Teuchos::RCP<LocalVector> out;
  if (equations.unknowns() == Unknowns::whole) {
    using Make = LocalVector* (*)(std::size_t);
    static const auto make =
        reinterpret_cast<Make>(symbol_of(module_file("dda_trilinos.so"), "dda_block_vector"));
    out = Teuchos::rcp(make(equations.size()));
  } else {
    out = Teuchos::rcp(new DenseVector(equations.size()));
  }
  std::ranges::copy(at.x, out->local().begin());
  return out;
}

/// What LOCA shares, destroyed with it.
class Global {
 public:
  Global(const Teuchos::RCP<Teuchos::ParameterList>& list, const std::shared_ptr<const ActiveSolve>& active)
      : data_(LOCA::createGlobalData(list, Teuchos::rcp(new PathStrategies(active)))) {}
  Global(const Global&) = delete;
  Global& operator=(const Global&) = delete;
  ~Global() { LOCA::destroyGlobalData(data_); }
  const Teuchos::RCP<LOCA::GlobalData>& data() const { return data_; }

 private:
  Teuchos::RCP<LOCA::GlobalData> data_;
};

/// LOCA's stepper, its iteration taken one try at a time: whether a converged one is the next point is judged
/// between `compute` and `postprocess`.
class Steps final : public LOCA::Stepper {
 public:
  Steps(const Global& global, const Teuchos::RCP<Group>& group, std::shared_ptr<ActiveSolve> active,
        const Teuchos::RCP<Teuchos::ParameterList>& list, const LocaSettings& settings)
      : LOCA::Stepper(global.data(), group, Teuchos::rcp(new EquationsTest(active)), list),
        active_(std::move(active)),
        nox_(list->sublist("NOX")),
        settings_(settings) {
    start();
    active_->is_start = false;
    before_ = getStepNumber();
  }

  int num_accepted() const { return getStepNumber() - before_; }

  Solved solve(const Solve& wanted) {
    refuse_pending();
    choose(wanted.method);
    Solved out;
    try {
      preprocess(status_);
      solverPtr->reset(*extended(wanted.guess, wanted.step));
      pending_ = true;
      out.converged = compute(Successful) == Successful;
    } catch (const char*) {  // LOCA throws a singular bordered system through its stepper
      active_->reason = singular;
    } catch (const std::logic_error&) {
      active_->reason = singular;
    }
    out.iterations = solverPtr->getNumIterations();
    if (!out.converged) out.reason = active_->reason;
    const NOX::Abstract::Group& last = out.converged ? *curGroupPtr : solverPtr->getSolutionGroup();
    const Teuchos::RCP<NOX::Abstract::Vector> solution = last.getX().clone(NOX::DeepCopy);
    const Extended parts = parts_of(*solution);
    const std::span<const double> x = local(std::as_const(parts.x));
    out.x.assign(x.begin(), x.end());
    out.load_factor = parts.load_factor;
    return out;
  }

  void accept(const Iterate& at) {
    curGroupPtr->setX(*extended(at, 0));  // the next step begins at s = 0
    status_ = postprocess(Successful);
    count(status_);
    pending_ = false;
  }

 private:
  static constexpr auto singular = "the bordered system is singular";

  void refuse_pending() {
    if (!pending_) return;
    status_ = postprocess(Unsuccessful);
    count(status_);
    pending_ = false;
  }

  void count(StepStatus status) {
    ++numTotalSteps;
    ++(status == Successful ? stepNumber : numFailedSteps);
  }

  /// NOX's solver is built anew for each try from its list.
  void choose(Method method) {
    constexpr double of_held = 0.6;  // what equilibria with a gauge held are found by
    nox_.sublist("Direction").set("Method", method == Method::walk ? "User Defined" : "Newton");
    Teuchos::ParameterList& search = nox_.sublist("Line Search");
    const bool is_held = method == Method::line_search;
    search.sublist("Backtrack").set("Reduction Factor", is_held ? of_held : settings_.reduction);
    search.set("Method", is_held                  ? "Backtrack"
                         : method == Method::walk ? "Full Step"
                                                  : settings_.line_search);
  }

  Teuchos::RCP<NOX::Abstract::Vector> extended(const Iterate& at, double s) const {
    Teuchos::RCP<NOX::Abstract::Vector> out = curGroupPtr->getX().clone(NOX::DeepCopy);
    const Extended parts = parts_of(*out);
    if (auto* dense = dynamic_cast<DenseVector*>(&parts.x)) dense->resize(at.x.size());
    std::ranges::copy(at.x, local(parts.x).begin());
    parts.load_factor = at.load_factor;
    parts.s = s;
    return out;
  }

  std::shared_ptr<ActiveSolve> active_;
  Teuchos::ParameterList& nox_;
  const LocaSettings settings_;
  StepStatus status_ = Successful;
  bool pending_ = false;
  int before_ = 0;  ///< steps that the start counts
};

class PathStepper final : public LocaStepper {
 public:
  explicit PathStepper(const LocaSettings& settings)
      : settings_(settings),
        active_(std::make_shared<ActiveSolve>()),
        list_(list_of(settings, active_)),
        global_(list_, active_) {}

  Solved solve(const Solve& wanted) override {
    active_->equations = &wanted.equations;
    active_->step = wanted.step;
    active_->reason.clear();
    if (!steps_) begin(wanted);
    return steps_->solve(wanted);
  }
  void accept(const Iterate& at) override { steps_->accept(at); }
  int num_steps() const override { return steps_ ? steps_->num_accepted() : 0; }

 private:
  void begin(const Solve& wanted) {
    const auto x = vector_of(wanted.equations, wanted.guess);
    const Teuchos::RCP<LOCA::MultiContinuation::ConstraintInterface> constraint =
        Teuchos::rcp(new ControlConstraint(active_, *x, wanted.guess.load_factor));
    auto& constraints = list_->sublist("LOCA").sublist("Constraints");
    constraints.set("Constraint Object", constraint);
    constraints.set("Constraint Parameter Names", Teuchos::rcp(new std::vector<std::string>{"lambda"}));
    const auto group = Teuchos::rcp(new Group(global_.data(), active_, x, wanted.guess.load_factor));
    steps_ = std::make_unique<Steps>(global_, group, active_, list_, settings_);
  }

  const LocaSettings settings_;
  std::shared_ptr<ActiveSolve> active_;
  Teuchos::RCP<Teuchos::ParameterList> list_;
  Global global_;
  std::unique_ptr<Steps> steps_;
};

}  // namespace
}  // namespace dda

/// What continuation/solve/loca.cpp loads.
extern "C" dda::LocaStepper* dda_loca_stepper(const dda::LocaSettings& settings) {
  return new dda::PathStepper(settings);
}
