#include "models/parameters.hpp"

namespace dda {

Kind<InterfaceParameters> interface_kind() {
  using P = InterfaceParameters;
  return Schema<P>("How two bodies are joined along a curve, or wherever two materials meet.")
      .texts("between", &P::between,
             {.fallback = std::vector<std::string>{},
              .text = "Two materials (or one twice: its sub-blocks); without it the entry's name is that of "
                      "a curve."})
      .choice("law", &P::law, interface_laws(), {.fallback = "bonded", .text = "What the interface does."})
      .choice("treatment", &P::treatment, treatments(),
              {.fallback = "consistent", .text = "How it is imposed."})
      .one_of(
          "points", &P::points,
          {{"gauss", PointRule::gauss}, {"vertices", PointRule::vertices}, {"midpoint", PointRule::midpoint}},
          {.fallback = PointRule::gauss,
           .text = "Interface points of a side: two Gauss points, its ends, its middle."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (!p.between.empty() && p.between.size() != 2) findings.add(where, "`between` takes two materials");
      })
      .kind();
}

Kind<SupportParameters> support_kind() {
  using P = SupportParameters;
  return Schema<P>("Stiff springs at a point or along a boundary.")
      .point("at", &P::at, {.text = "The point; or give `on`."})
      .point("inside", &P::inside,
             {.text = "A point inside the block that is meant where several blocks meet."})
      .text("on", &P::on, {.text = "Name of a boundary; two springs per side."})
      .one_of("fix", &P::fix,
              {{"x", Fix::x},
               {"y", Fix::y},
               {"xy", Fix::xy},
               {"normal", Fix::normal},
               {"rotation", Fix::rotation}},
              {.text = "What is held; or give `direction`."})
      .point("direction", &P::direction,
             {.dimension = dimension::none, .text = "A direction that is held, any length."})
      .number("stiffness", &P::stiffness,
              {.dimension = dimension::stiffness,
               .bounds = above(0),
               .text = "Spring stiffness; the deck's default if absent."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.at.has_value() == p.on.has_value()) findings.add(where, "a support needs either `at` or `on`");
        if (p.fix.has_value() == p.direction.has_value())
          findings.add(where, "a support needs either `fix` or `direction`");
        if (p.direction && p.direction->norm() == 0) findings.add(where, "`direction` must not be zero");
        if (p.at && p.fix == Fix::normal) findings.add(where, "`fix: normal` needs a boundary (`on`)");
      })
      .kind();
}

Kind<StageParameters> stage_kind() {
  using P = StageParameters;
  return Schema<P>("Loads that act together.")
      .text("name", &P::name, {.fallback = "loading", .text = "Name of the stage."})
      .list("loads", &P::loads, loads().kind(), {.at_least = 1, .text = "The loads at full value."})
      .kind();
}

}  // namespace dda
