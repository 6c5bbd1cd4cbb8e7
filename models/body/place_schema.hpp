#pragma once

#include "framework/deck/schema.hpp"
#include "models/body/place.hpp"

namespace dda {

/// Adds a finding unless there is one of `at` and `over`, and of that two different ends.
inline void check_place(const Place& place, const Position& where, Findings& findings) {
  if (place.at.has_value() == place.over.has_value())
    findings.add(where, "give either `at`, a point, or `over: [from, to]`, a patch of the boundary");
  if (!place.over) return;
  if (place.over->size() != 2)
    findings.add(where, "`over` takes the two ends of the patch: [from, to]");
  else if (place.over->front() == place.over->back())
    findings.add(where, "the two ends of `over` are the same; for a point give `at`");
}

/// Declares `at`, `inside` and `over` of parameters that derive from Place, and checks nothing.
template <class P>
void declare_place(Schema<P>& schema) {
  schema.spot("at", &P::at, {.text = "The point, or the name of one in `scene.points`; or give `over`."})
      .spot("inside", &P::inside,
            {.text = "A point inside the block that is meant where several blocks meet at `at`, otherwise "
                     "they share; with `over` a point on the side of a slit that is meant."})
      .spots("over", &P::over,
             {.text = "[from, to], two points of a straight boundary: what acts is spread evenly over the "
                      "sides of the blocks between them, a displacement is the mean there. Where blocks can "
                      "be torn out under a point, a patch several blocks wide holds them."});
}

/// The same, of which there must be one.
template <class P>
void add_place(Schema<P>& schema) {
  declare_place(schema);
  schema.check(
      [](const P& p, const Position& where, Findings& findings) { check_place(p, where, findings); });
}

}  // namespace dda
