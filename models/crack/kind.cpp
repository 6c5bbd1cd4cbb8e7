#include "models/crack/kind.hpp"

namespace dda {
namespace {

Kind<CrackBegin> crack_begin_kind() {
  using P = CrackBegin;
  return Schema<P>("A place on the outline of a block, such as the tip of a notch, and a first direction.")
      .spot("at", &P::at, {.text = "The place, or the name of one in `scene.points`."})
      .point("direction", &P::direction,
             {.dimension = dimension::none, .text = "Direction (lx, ly) into the body, any length."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.direction.norm() == 0) findings.add(where, "`direction` must not be zero");
      })
      .kind();
}

/// Where cracks begin.
Schema<CrackParameters> with_begin(Schema<CrackParameters> schema) {
  using P = CrackParameters;
  return schema
      .value(
          "begin", &P::begin, list_or_word(crack_begin_kind(), "automatic"),
          {.text = "Where cracks begin, one each; or `automatic`: where the boundary or an interface of the "
                   "regions bears the largest tension in parts of the strength, once it is 0.9 of it."})
      .integer(
          "most", &P::most,
          {.bounds = between(1, 1000), .text = "Of `begin: automatic`: the number of cracks; 1 without it. One that has cut off a corner does not count."})
      .number("apart", &P::apart,
              {.dimension = dimension::length,
               .bounds = at_least(0),
               .text = "Of `begin: automatic`: least distance of a new crack to any other that a straight "
                       "line through the body leads to; without it 4 block "
                       "sizes or 0.3 E Gf/ft², whichever is more."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (!p.is_automatic() && (p.most || p.apart))
          findings.add(where, "`most` and `apart` are for `begin: automatic`");
      });
}

}  // namespace

Kind<CrackParameters> crack_kind() {
  using P = CrackParameters;
  return with_begin(
             Schema<P>(
                 "Cracks through the blocks of some regions, whose inner sides are bonded from then on."))
      .texts("through_blocks", &P::through_blocks, {.at_least = 1, .text = "Names of the regions."})
      .text(
          "law", &P::law,
          {.fallback = "",
           .text = "Interface whose law the cracks have; if empty the one between the region's material and "
                   "itself."})
      .choice("direction", &P::direction, crack_directions(),
              {.fallback = "nonlocal_stress", .text = "Which way they go on."})
      .number(
          "shortest_segment", &P::shortest_segment,
          {.fallback = 0.5,
           .bounds = above(0),
           .text = "Shortest straight piece, in block sizes: a shorter cut goes straight on through the next "
                   "block."})
      .number(
          "stiffness", &P::stiffness,
          {.fallback = 100.0,
           .bounds = at_least(0),
           .text = "Stiffness of a closed cut in units of that of the block's sides; it is never less than "
                   "what keeps the structure stable."})
      .texts("end_at", &P::end_at,
             {.fallback = std::vector<std::string>{}, .text = "Interfaces at which the cracks end."})
      .kind();
}

}  // namespace dda
