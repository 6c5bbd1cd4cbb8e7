#include "continuation/follow/path_parameters.hpp"

namespace dda {
namespace {

Schema<StepSizes> step_schema() {
  using P = StepSizes;
  return Schema<P>("How closely the path is followed.")
      .number("accuracy", &P::accuracy,
              {.fallback = 0.02,
               .bounds = above(0) & at_most(0.5),
               .text = "Deviation from the tangent that one step aims at, relative to the largest load and "
                       "displacement."})
      .number(
          "largest", &P::largest,
          {.fallback = 0.1,
           .bounds = above(0) & at_most(1),
           .text = "Largest predicted change of the load in one step, relative to the largest load so far."});
}

Schema<StopRules> stop_schema() {
  using P = StopRules;
  return Schema<P>("Where the path ends.")
      .number(
          "load_below", &P::load_below,
          {.fallback = 0.1,
           .bounds = at_least(0) & below(1),
           .text =
               "End where the load has fallen to this share of its peak; 0 = follow to complete rupture."})
      .map("gauges", &P::gauges, number_kind({}, {}),
           {.fallback = {{}}, .text = "End where a gauge reaches a value, by name."})
      .integer(
          "after_steps", &P::after_steps,
          {.fallback = 0,
           .bounds = at_least(0),
           .text = "End, the goal being reached, after this number of accepted steps; 0 = no such goal."})
      .integer("steps", &P::steps,
               {.fallback = 1000,
                .bounds = at_least(1),
                .text = "Limit: a run that has accepted so many steps and not reached its goal is stopped "
                        "early."})
      .number("energy_error", &P::energy_error,
              {.fallback = 0.05,
               .bounds = above(0),
               .text = "Limit: no step is accepted that leaves a larger share of the work done so far "
                       "unaccounted for by stored and dissipated energy and the jumps."});
}

Schema<NewtonParameters> newton_schema() {
  using P = NewtonParameters;
  return Schema<P>("When a Newton iteration ends.")
      .number("tolerance", &P::tolerance,
              {.fallback = 1e-9,
               .bounds = above(0) & at_most(1e-4),
               .text = "Residual force relative to the force level of the blocks."})
      .integer("max_iterations", &P::max_iterations,
               {.fallback = 15, .bounds = between(2, 200), .text = "Iterations before a step is given up."});
}

Schema<MultiplierParameters> multiplier_schema() {
  using P = MultiplierParameters;
  return Schema<P>("When the multipliers of augmented Lagrangian joints are good.")
      .number("tolerance", &P::tolerance,
              {.fallback = 1e-8,
               .bounds = above(0) & at_most(1e-2),
               .text = "Largest gap left, in units of the shortening of a block under the largest traction."})
      .integer("max_iterations", &P::max_iterations,
               {.fallback = 1000, .bounds = at_least(1), .text = "Iterations before a step is given up."})
      .boolean(
          "predicted", &P::predicted,
          {.fallback = true,
           .text =
               "Start each step from the multipliers that the path's tangent predicts, not the last ones."});
}

/// What solves the equations of a step.
Schema<PathParameters> with_solvers(Schema<PathParameters> schema) {
  using P = PathParameters;
  using Update = LinearSystem::Update;
  return schema.section("newton", &P::newton, newton_schema())
      .section("multipliers", &P::multipliers, multiplier_schema())
      .choice("linear", &P::linear, direct_solvers(), {.fallback = "cholmod", .text = "Linear solver."})
      .one_of(
          "update", &P::update, {{"low_rank", Update::low_rank}, {"refactorise", Update::refactorise}},
          {.fallback = Update::low_rank,
           .text = "How the factorisation follows cracking: low-rank updates of one factorisation, or a new "
                   "one each time."})
      .texts(
          "expected_to_stop", &P::expected_to_stop,
          {.fallback = std::vector<std::string>{},
           .text = "Controls that this scene is known to stop early; `dda compare` takes that as a success."})
      .passthrough("nox", &P::nox, {.text = "Parameters for NOX, as they stand."})
      .passthrough("loca", &P::loca, {.text = "Parameters for LOCA, as they stand."});
}

}  // namespace

Schema<PathParameters> path_schema() {
  using P = PathParameters;
  return with_solvers(
      Schema<P>("How the equilibrium path is followed.")
          .choice("control", &P::control, controls(),
                  {.fallback = "staged", .text = "What is prescribed along the path."})
          .section("step", &P::step, step_schema())
          .section("stop", &P::stop, stop_schema())
          .boolean(
              "stability", &P::stability,
              {.fallback = true,
               .text = "Count the negative eigenvalues of the stiffness at every step: columns of the curve, "
                       "and bifurcations among the events of the summary."})
          .one_of(
              "branch", &P::branch, {{"follow", Branching::follow}, {"switch", Branching::to_lowest}},
              {.fallback = Branching::follow,
               .text =
                   "At a bifurcation go on along the same branch, or switch to the one on which the load "
                   "falls fastest; the branch not taken is then followed as well, in a folder of its own."})
          .text(
              "load_gauge", &P::load_gauge,
              {.fallback = "",
               .text = "Gauge whose peak counts; if empty the load factor times the loads' resultant, or the "
                       "driven reactions."})
          .number("peak_tolerance", &P::peak_tolerance,
                  {.fallback = 1e-4,
                   .bounds = above(0) & at_most(0.1),
                   .text = "The peak load is bracketed to this relative width."}));
}

}  // namespace dda
