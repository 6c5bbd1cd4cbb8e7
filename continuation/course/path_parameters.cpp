#include "continuation/course/path_parameters.hpp"

#include <fmt/format.h>

#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

/// Sizes in the unit of what the control prescribes, and what they follow.
Schema<StepSizes> with_sizes(Schema<StepSizes> schema) {
  using P = StepSizes;
  return schema
      .number("first", &P::first,
              {.bounds = above(0),
               .text = "Length of the first step under a control, in the unit of what it prescribes."})
      .number("shortest", &P::shortest,
              {.bounds = above(0), .text = "Steps that would have to be shorter end the path; same unit."})
      .number("longest", &P::longest, {.bounds = above(0), .text = "No step is longer; same unit."})
      .one_of("sizing", &P::sizing,
              {{"deviation", Sizing::deviation},
               {"iterations", Sizing::iterations},
               {"constant", Sizing::constant}},
              {.fallback = Sizing::deviation,
               .text = "What the next step is sized by: how well the tangent has predicted the last one "
                       "(`accuracy`), how many iterations that took, or nothing."})
      .number("aggressiveness", &P::aggressiveness,
              {.bounds = at_least(0) & at_most(10),
               .text = "a of `sizing: iterations`, 0.5 if not given: a step that took n of N iterations is "
                       "followed by one that is 1 + a (1 - n/N)^2 times as long."})
      .number("cut", &P::cut,
              {.fallback = 0.25,
               .bounds = above(0) & below(1),
               .text = "A step that fails is tried again with this share of its length."})
      .one_of(
          "predictor", &P::predictor,
          {{"tangent", Predictor::tangent}, {"secant", Predictor::secant}, {"constant", Predictor::constant}},
          {.fallback = Predictor::tangent,
           .text = "Where Newton's method begins: on the tangent, on the line through the last two points "
                   "(on the tangent where these lie less than a tenth of the step apart), or at the last "
                   "point."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.aggressiveness && p.sizing != Sizing::iterations)
          findings.add(where, "aggressiveness: only `sizing: iterations` has one");
        if (p.shortest && p.longest && *p.shortest > *p.longest)
          findings.add(where, "shortest: no step is as long, see `longest`");
      });
}

Schema<StepSizes> step_schema() {
  using P = StepSizes;
  return with_sizes(
      Schema<P>("How closely the path is followed.")
          .number(
              "accuracy", &P::accuracy,
              {.fallback = 0.02,
               .bounds = above(0) & at_most(0.5),
               .text = "Deviation from the tangent that one step aims at, relative to the largest load and "
                       "displacement."})
          .number("largest", &P::largest,
                  {.fallback = 0.1,
                   .bounds = above(0) & at_most(1),
                   .text = "Largest predicted change of the load in one step, relative to the largest load "
                           "so far."}));
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
               {.bounds = at_least(1),
                .text = "Limit: a run that has accepted so many steps and not reached its goal is stopped "
                        "early. 1000 if it is not given, and 20 more for every point of an interface that "
                        "loses its strength at once, which takes steps of its own."})
      .number("load_factor_above", &P::load_factor_above,
              {.text = "End where the load factor of the last stage has risen to this value."})
      .number("load_factor_below", &P::load_factor_below,
              {.text = "End where the load factor of the last stage has fallen to this value."})
      .number("energy_error", &P::energy_error,
              {.fallback = 0.05,
               .bounds = above(0),
               .text = "Limit: no step is accepted that leaves a larger share of the work done so far "
                       "unaccounted for by stored and dissipated energy and the jumps."});
}

/// Controls by name, which there must be.
void check_expected(const PathParameters& p, const Position& where, Findings& findings) {
  std::vector<std::string> names;
  for (const FamilyMember* control : controls().entries()) names.push_back(control->name);
  for (const std::string& name : p.expected_to_stop)
    if (!controls().find(name))
      findings.add(where,
                   fmt::format("expected_to_stop: unknown control '{}'{}", name, suggest(name, names)));
}

constexpr auto about_iterations =
    "No iteration of Newton's method, and no walk through contacts, takes more; one that has not converged "
    "by then has failed, and another way or a shorter step is tried. If not given: 15; on the cracked points "
    "alone those that bring a new set of cracking, unloading and touching points do not count, up to 50 in "
    "all; 30 where a displacement is held to find what a release leads to.";

Schema<NewtonParameters> newton_schema() {
  using P = NewtonParameters;
  return Schema<P>("When a Newton iteration ends.")
      .number("tolerance", &P::tolerance,
              {.fallback = 1e-9,
               .bounds = above(0) & at_most(1e-4),
               .text = "Residual force relative to the force level of the blocks."})
      .integer("max_iterations", &P::max_iterations, {.bounds = between(2, 200), .text = about_iterations})
      .one_of("line_search", &P::line_search,
              {{"full_step", LineSearch::full_step},
               {"backtrack", LineSearch::backtrack},
               {"polynomial", LineSearch::polynomial}},
              {.fallback = LineSearch::full_step,
               .text = "NOX's line search: none, or shorter and shorter, or by a parabola, until the "
                       "residual falls."})
      .number("reduction", &P::reduction,
              {.bounds = above(0) & below(1),
               .text = "Of `line_search: backtrack`, 0.5 if not given: each trial is so much of the last."})
      .integer(
          "output", &P::output,
          {.fallback = 0,
           .bounds = at_least(0),
           .text = "What NOX and LOCA print into nox.log of the run folder, a sum of NOX's bits: 1 warnings, "
                   "2 outer iterations, 4 inner ones of a line search, 8 NOX's parameters, 16 details, "
                   "32 status tests, 256 steps of LOCA, 512 their details, 1024 LOCA's parameters; NOX's "
                   "other bits print nothing here; 0 nothing."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.reduction && p.line_search != LineSearch::backtrack)
          findings.add(where, "reduction: only `line_search: backtrack` has one");
      });
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
      .text("parameters", &P::lists,
            {.fallback = "",
             .text =
                 "A Teuchos::ParameterList with the sublists NOX and LOCA, an XML or YAML file; what it sets "
                 "stands for keys of the deck, in effective_deck.yaml. See `dda explain parameters`."})
      .passthrough("nox", &P::nox, {.text = "The sublist NOX of such a list."})
      .passthrough("loca", &P::loca, {.text = "The sublist LOCA of such a list."});
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
          .one_of(
              "then", &P::then, {{"end", AfterPath::end}, {"motion", AfterPath::motion}},
              {.text = "What comes after the path: nothing, or the `motion` of what is left, as that section "
                       "says or by its defaults. If not given, a motion where the deck has that section."})
          .text(
              "load_gauge", &P::load_gauge,
              {.fallback = "",
               .text = "Gauge whose peak counts; if empty the load factor times the loads' resultant, or the "
                       "driven reactions."})
          .number("peak_tolerance", &P::peak_tolerance,
                  {.fallback = 1e-4,
                   .bounds = above(0) & at_most(0.1),
                   .text = "The peak load is bracketed to this relative width."})
          .check(check_expected));
}

std::vector<std::string> unheeded_keys(const PathParameters& path, const Control& control) {
  const PathParameters usual;
  const StepSizes& step = path.step;
  std::vector<std::string> out;
  const auto look = [&](const char* key, bool is_set) {
    if (is_set) out.emplace_back(key);
  };
  if (!control.sizes_steps()) {
    look("step.first", step.first.has_value());
    look("step.shortest", step.shortest.has_value());
    look("step.longest", step.longest.has_value());
    look("step.sizing", step.sizing != usual.step.sizing);
    look("step.aggressiveness", step.aggressiveness.has_value());
    look("step.cut", step.cut != usual.step.cut);
    look("step.predictor", step.predictor != usual.step.predictor);
    look("branch", path.branch != usual.branch);
    look("peak_tolerance", path.peak_tolerance != usual.peak_tolerance);
  }
  if (control.load_increment() > 0) {
    look("step.accuracy", step.accuracy != usual.step.accuracy);
    look("step.largest", step.largest != usual.step.largest);
    look("stop.energy_error", path.stop.energy_error != usual.stop.energy_error);
  }
  return out;
}

}  // namespace dda
