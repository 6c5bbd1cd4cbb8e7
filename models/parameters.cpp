#include "models/parameters.hpp"

#include <algorithm>
#include <iterator>

namespace dda {

void check_interface(const InterfaceParameters& p, const Position& where, Findings& findings) {
  if (p.crack_normal && p.crack_normal->norm() == 0) findings.add(where, "`crack_normal` must not be zero");
  if (!p.between.empty() && p.between.size() != 2) findings.add(where, "`between` takes two materials");
  if (!p.between.empty() && !p.boundary.empty())
    findings.add(where, "an interface has either `between` or `boundary`");
}

Schema<WaterParameters> water_schema() {
  using P = WaterParameters;
  return Schema<P>(
             "Water that follows into the cracks of an interface, or stands between bodies that only touch, "
             "and "
             "presses their faces apart.")
      .value("pressure", &P::pressure, formula_kind(dimension::stress),
             {.text = "Pressure of the water there, a number or an expression of x and y: up to a level H "
                      "\"rho*g*(H - y)\". Where it is not positive there is no water. It stays as it is "
                      "whatever the "
                      "load factor."})
      .number(
          "opening", &P::opening,
          {.dimension = dimension::length,
           .bounds = above(0),
           .text =
               "Opening at which a crack bears the whole pressure; it grows in proportion from nothing where "
               "the crack begins. Without it that at which its traction has vanished, which laws without an "
               "end do not have, and that bodies that only touch need none of."});
}

Kind<InterfaceParameters> interface_kind() {
  using P = InterfaceParameters;
  return Schema<P>("How two bodies are joined along a curve, or wherever two materials meet.")
      .texts("between", &P::between,
             {.fallback = std::vector<std::string>{},
              .text = "Two materials (or one twice: its sub-blocks); without it the entry's name is that of "
                      "a curve."})
      .text("boundary", &P::boundary,
            {.fallback = "",
             .text = "A straight boundary that is a plane of symmetry: the joint is between the structure "
                     "and its mirror image, "
                     "may crack, and never slides. Loads, reactions and energies are those of one half."})
      .choice("law", &P::law, interface_laws(), {.fallback = "bonded", .text = "What the interface does."})
      .choice("treatment", &P::treatment, treatments(),
              {.fallback = "consistent", .text = "How it is imposed."})
      .one_of("points", &P::points,
              {{"gauss", PointRule::gauss},
               {"gauss_2", PointRule::gauss_2},
               {"vertices", PointRule::vertices},
               {"midpoint", PointRule::midpoint}},
              {.text = "Interface points of a side: Gauss points, two of them and three beside blocks of "
                       "second order; "
                       "always two; its ends; its middle. Without it the ends for treatments with "
                       "multipliers (two Gauss "
                       "points beside blocks of second order, which bear neither ends nor middle), Gauss "
                       "points for the "
                       "others."})
      .section("field", &P::field, field_schema())
      .section("water", &P::water, water_schema())
      .point(
          "crack_normal", &P::crack_normal,
          {.dimension = dimension::none,
           .text = "Normal n of the plane in which the structure is known to crack, any length. A heuristic "
                   "for blocks that cracks run between: strength and fracture energy of a side with normal m "
                   "are max(|n·m|, 0.3) times those of the law, so that a zigzag costs what its projection "
                   "does. Where the plane is not known `cracks` through blocks need no such correction."})
      .check(check_interface)
      .kind();
}

void check_support(const SupportParameters& p, const Position& where, Findings& findings) {
  if (p.at.has_value() + p.over.has_value() + p.boundary.has_value() != 1)
    findings.add(where, "a support needs one of `at`, `over` and `boundary`");
  if (p.over && p.over->size() != 2)
    findings.add(where, "`over` takes the two ends of the patch: [from, to]");
  if (p.fix.has_value() == p.direction.has_value())
    findings.add(where, "a support needs either `fix` or `direction`");
  if (p.direction && p.direction->norm() == 0) findings.add(where, "`direction` must not be zero");
  if (p.at && p.fix == Fix::normal)
    findings.add(where, "`fix: normal` needs a `boundary` or a patch (`over`)");
  if (!p.over && p.fix == Fix::straight) findings.add(where, "`fix: straight` needs a patch (`over`)");
}

Kind<SupportParameters> support_kind() {
  using P = SupportParameters;
  return Schema<P>("Stiff springs at a point, at the mean of a patch, or along a boundary.")
      .spot("at", &P::at,
            {.text = "The point, or the name of one in `scene.points`; or give `over` or `boundary`."})
      .spot(
          "inside", &P::inside,
          {.text = "A point inside the block that is meant where several blocks meet; with `over` a point on "
                   "the side of a slit that is meant."})
      .spots(
          "over", &P::over,
          {.text = "[from, to], two points of a straight boundary: the mean displacement between them is "
                   "held, so that the reaction is an even traction over the sides of the blocks there, and "
                   "the patch may turn (`fix: rotation` holds that)."})
      .text("boundary", &P::boundary,
            {.text = "Name of a boundary, held in every point: two springs per side."})
      .one_of("fix", &P::fix,
              {{"x", Fix::x},
               {"y", Fix::y},
               {"xy", Fix::xy},
               {"normal", Fix::normal},
               {"rotation", Fix::rotation},
               {"straight", Fix::straight}},
              {.text = "What is held; or give `direction`. `straight`, of a patch: it stays straight but may "
                       "move and turn, as under a stiff plate on a hinge; beside what holds or loads its "
                       "mean. Nothing is borne by it in sum."})
      .point("direction", &P::direction,
             {.dimension = dimension::none, .text = "A direction that is held, any length."})
      .number("stiffness", &P::stiffness,
              {.dimension = dimension::stiffness,
               .bounds = above(0),
               .text = "Spring stiffness; the deck's default if absent."})
      .text("from", &P::from,
            {.fallback = "",
             .text = "Name of the stage at whose beginning it is put in, one that a load factor multiplies."})
      .check(check_support)
      .kind();
}

Kind<StageParameters> stage_kind() {
  using P = StageParameters;
  return Schema<P>("Loads that act together.")
      .text("name", &P::name, {.fallback = "loading", .text = "Name of the stage."})
      .list("loads", &P::loads, loads().kind(),
            {.at_least = 0,
             .text = "The loads at full value; without any the stage goes on with those before it. After a "
                     "stage with `until` they are multiplied by a load factor of their own, and what was "
                     "there is held."})
      .map("until", &P::until, number_kind({}, {}),
           {.fallback = {{}},
            .text =
                "Gauge values (`load` is the load gauge, `load_factor` what multiplies the loads) that end "
                "this stage; the next one goes on from there."})
      .boolean("unload", &P::unload,
               {.fallback = false,
                .text = "Turn round: lead the one gauge in `until` to its value, also through zero and as "
                        "far beyond as is "
                        "asked, what slides sticking first and cracks staying as they are."})
      .kind();
}

std::vector<StageParameters> ModelParameters::loaded_stages() const {
  std::vector<StageParameters> out;
  std::ranges::copy_if(stages, std::back_inserter(out),
                       [](const auto& stage) { return !stage.loads.empty(); });
  return out;
}

std::size_t ModelParameters::num_dead_stages() const {
  const std::vector<StageParameters> loaded = loaded_stages();
  const auto first = std::ranges::find_if(loaded, [](const auto& stage) { return !stage.until.empty(); });
  return loaded.empty() ? 0 : std::min<std::size_t>(first - loaded.begin(), loaded.size() - 1);
}

std::vector<std::size_t> ModelParameters::followed_stages() const {
  std::vector<std::size_t> out;
  for (std::size_t i = num_dead_stages(); i < stages.size(); ++i)
    if (!stages[i].loads.empty()) out.push_back(i);
  return out;
}

std::vector<StageParameters> ModelParameters::legs() const {
  return {stages.begin() + static_cast<std::ptrdiff_t>(num_dead_stages()), stages.end()};
}

void check_stages(const std::vector<StageParameters>& stages, Findings& findings) {
  bool is_followed = false;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const StageParameters& stage = stages[i];
    const bool is_last = i + 1 == stages.size(), before_leg = !is_last && stages[i + 1].loads.empty();
    is_followed = is_followed || !stage.until.empty();
    if (i == 0 && stage.loads.empty()) findings.add(stage.where, "the first stage needs `loads`");
    if (before_leg && stage.until.empty())
      findings.add(stage.where, "a stage that is followed by one without loads needs `until`");
    else if (is_followed && !is_last && stage.until.empty())
      findings.add(stage.where,
                   "a stage after one with `until` is multiplied by the load factor, too, and needs `until` "
                   "if others come after it (`until: {load_factor: 1}` brings its loads to full value); "
                   "loads that are applied in full at once come before the first `until`");
    if (stage.unload && (stage.until.size() != 1 || !stage.loads.empty()))
      findings.add(stage.where, "`unload` needs one gauge in `until` and no `loads` of its own");
  }
}

}  // namespace dda
