#include "continuation/motion/motion_parameters.hpp"

namespace dda {
namespace {

Schema<MeetingParameters> meeting_schema() {
  using P = MeetingParameters;
  return Schema<P>("How bodies meet that nothing joins any more.")
      .choice("law", &P::law, contact_laws(), {.fallback = "wall", .text = "What an overlap stores."})
      .number("stiffness", &P::stiffness,
              {.fallback = 10,
               .bounds = between(0.1, 1000),
               .text = "Stiffness where a corner meets a side, in E · thickness/2."})
      .number("offset", &P::offset,
              {.fallback = 1e-3,
               .bounds = between(1e-5, 2e-2),
               .text = "By how much outlines are shrunk to cores that never meet, over the size of the "
                       "smallest block; corners are round by it."})
      .number("friction", &P::friction,
              {.bounds = at_least(0),
               .text = "Coefficient of friction, tan φ, of bodies between which no interface has one."});
}

/// What acts on the structure once it is let go.
Schema<MotionParameters> with_actions(Schema<MotionParameters> schema) {
  using P = MotionParameters;
  return schema
      .one_of("loads", &P::loads, {{"keep", KeptLoads::all}, {"drop", KeptLoads::dead}},
              {.fallback = KeptLoads::all,
               .text = "Whether the loads of the last stage stay as they are at the end of the path; those "
                       "of the stages before stay in any case. They keep their directions."})
      .boolean("supports", &P::keeps_supports,
               {.fallback = true,
                .text = "Whether the supports of the path go on to hold the material points they hold; "
                        "without them the structure rests on what it meets."})
      .number("push", &P::push,
              {.fallback = 0.01,
               .bounds = at_least(0) & at_most(1),
               .text = "Share by which the last load grows where the path has ended while it was falling: "
                       "such a state may close again as well as go on."})
      .point("gravity", &P::gravity,
             {.fallback = Vec2(Vec2::Zero()),
              .dimension = dimension::length,
              .text = "Acceleration (gx, gy) of all that moves, beside the loads [per s²]: (0, 0) where the "
                      "weight is a load already."})
      .texts("held", &P::held,
             {.fallback = {{}},
              .text = "Names of regions whose blocks stay where they are, such as the ground."});
}

}  // namespace

Schema<MotionParameters> motion_schema() {
  using P = MotionParameters;
  return with_actions(
             Schema<P>("What happens from the end of the path on: pieces move, part, meet, slide and come "
                       "to rest. Needs the `density` of every material that moves. Times are in seconds."))
      .number("time", &P::time,
              {.bounds = above(0), .text = "The motion ends after so long at the latest [s]."})
      .boolean("stop_at_rest", &P::stops_at_rest,
               {.fallback = true, .text = "It ends before where everything has come to rest."})
      .section("contact", &P::contact, meeting_schema())
      .number("step", &P::step,
              {.fallback = 0.01,
               .bounds = between(1e-5, 0.1),
               .text = "Time step in √(L/g), L the size of the smallest block that moves and g the "
                       "acceleration of all by their loads; a tenth of it while joints tear."})
      .number("frame_every", &P::frame_every,
              {.fallback = 0,
               .bounds = at_least(0),
               .text = "Time between the states that are stored [s]; 0 stores about a hundred over `time`."});
}

}  // namespace dda
