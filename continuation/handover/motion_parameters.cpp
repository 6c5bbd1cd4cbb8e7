#include "continuation/handover/motion_parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace dda {
namespace {

Kind<RegionNames> region_names_kind() {
  const Kind<std::vector<std::string>> names = list_of(text_kind());
  const auto read = [names](const Node& node, const Reading& reading) -> std::optional<RegionNames> {
    auto found = names.read(node, reading);
    if (!found) return {};
    RegionNames out{std::move(*found), {}};
    for (const Node& item : node.items) out.where.push_back(item.where);
    return out;
  };
  return {names.info, read, [names](const RegionNames& of) { return names.echo(of.names); }};
}

Kind<PairParameters> pair_kind() {
  using P = PairParameters;
  return Schema<P>("What bodies of two materials do where they meet.")
      .texts("between", &P::between, {.at_least = 1, .text = "Two materials, or one twice."})
      .number("friction", &P::friction, {.bounds = at_least(0), .text = "Coefficient of friction, tan φ."})
      .number("restitution", &P::restitution,
              {.bounds = between(0, 1), .text = "Speed after an impact over that before."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.between.size() != 2) findings.add(where, "`between` takes two materials");
        if (!p.friction && !p.restitution)
          findings.add(where, "a pair needs a `friction` or a `restitution` of its own");
      })
      .kind();
}

/// One pair may stand twice, once with what it has of friction and once with what it gives back, but not with two answers.
void check_pairs(const MeetingParameters& p, const Position&, Findings& findings) {
  const auto have = [](const PairParameters& a, const PairParameters& b) {
    return (a.friction && b.friction) || (a.restitution && b.restitution);
  };
  for (auto pair = p.pairs.begin(); pair != p.pairs.end(); ++pair)
    for (auto before = p.pairs.begin(); before != pair; ++before)
      if (std::ranges::is_permutation(pair->between, before->between) && have(*pair, *before))
        findings.add(pair->where,
                     fmt::format("motion.contact.pairs: `between: [{}]` stands here a second time; keep one",
                                 fmt::join(pair->between, ", ")));
}

Kind<VelocityParameters> velocity_kind() {
  using P = VelocityParameters;
  return Schema<P>("Blocks that are thrown.")
      .texts("regions", &P::regions, {.at_least = 1, .text = "Names of regions."})
      .point("velocity", &P::velocity,
             {.fallback = Vec2(Vec2::Zero()),
              .dimension = dimension::length,
              .text = "Velocity of their centroids (vx, vy) [per s]."})
      .number("spin", &P::spin,
              {.fallback = 0,
               .text = "Rate at which each block turns about its centroid, counter-clockwise "
                       "[rad/s]."})
      .kind();
}

Kind<DriveParameters> drive_kind() {
  using P = DriveParameters;
  return Schema<P>("Blocks that are moved, such as a ground that shakes or a support that gives way.")
      .texts("regions", &P::regions, {.at_least = 1, .text = "Names of regions; they are `held` thereby."})
      .point("direction", &P::direction,
             {.dimension = dimension::none, .text = "Direction (lx, ly), any length."})
      .choice("displacement", &P::displacement, time_functions(), {.text = "Displacement over time."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.direction.norm() == 0) findings.add(where, "`direction` must not be zero");
      })
      .kind();
}

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
               .text = "Coefficient of friction, tan φ, of bodies for which neither an interface nor `pairs` "
                       "have one. If not given that of the interfaces, where all have the same."})
      .number("restitution", &P::restitution,
              {.fallback = 0,
               .bounds = between(0, 1),
               .text = "Speed at which bodies part after an impact over that at which they have met; 0: they "
                       "stay together."})
      .list("pairs", &P::pairs, pair_kind(),
            {.at_least = 0,
             .text = "Friction and restitution of some pairs of materials. Blocks beside an interface have "
                     "the friction of its law."})
      .check(check_pairs);
}

Schema<DampingRates> damping_schema() {
  using P = DampingRates;
  return Schema<P>(
             "Rayleigh's damping C = a M + b K of what moves; a vibration of circular frequency w has "
             "the damping ratio (a/w + b w)/2.")
      .number("mass", &P::mass,
              {.fallback = 0,
               .bounds = at_least(0),
               .text = "a [1/s]: it slows every motion down, that of fragments in flight too."})
      .number("stiffness", &P::stiffness,
              {.fallback = 0,
               .bounds = at_least(0),
               .text = "b [s]: of strains, joints that hold, and springs of supports, at their own rates; "
                       "rotations and contacts have none."});
}

/// What acts on the structure once it is let go.
Schema<MotionParameters> with_actions(Schema<MotionParameters> schema) {
  using P = MotionParameters;
  return schema
      .one_of("loads", &P::loads, {{"keep", KeptLoads::all}, {"drop", KeptLoads::dead}},
              {.fallback = KeptLoads::all,
               .text = "Whether the loads of the last stage stay as they are at the end of the path; those "
                       "of the stages before stay in any case. They keep their directions."})
      .boolean(
          "supports", &P::keeps_supports,
          {.fallback = true,
           .text = "Whether the supports of the path go on to hold the material points they hold, but for "
                   "those of regions that are `held` or `driven`; without them the structure rests on what "
                   "it meets."})
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
      .value("held", &P::held, region_names_kind(),
             {.fallback = RegionNames{},
              .text = "Names of regions whose blocks stay where they are, such as the ground."})
      .list("driven", &P::driven, drive_kind(),
            {.at_least = 0, .text = "Regions that are moved over time; displacements add up."})
      .list("velocities", &P::velocities, velocity_kind(),
            {.at_least = 0, .text = "Regions that do not begin at rest."});
}

}  // namespace

Schema<MotionParameters> motion_schema() {
  using P = MotionParameters;
  return with_actions(
             Schema<P>("What happens from the end of the path on: pieces move, part, meet, slide and come "
                       "to rest; in a deck without `stages` from the undeformed structure on. Needs the "
                       "`density` of every material that moves. Times are in seconds."))
      .number(
          "time", &P::time,
          {.fallback = 0,
           .bounds = at_least(0),
           .text = "The motion ends after so long at the latest [s]; 0: 40 √(D/g), D the size of the "
                   "structure and g the acceleration of all by their loads, and what has not come to rest "
                   "by then is stopped early."})
      .boolean("stop_at_rest", &P::stops_at_rest,
               {.fallback = true, .text = "It ends before where everything has come to rest."})
      .choice("integrator", &P::integrator, integrators(),
              {.fallback = "free_flight", .text = "How the motion goes from one instant to the next."})
      .section("damping", &P::damping, damping_schema())
      .section("contact", &P::contact, meeting_schema())
      .number("step", &P::step,
              {.fallback = 0.01,
               .bounds = between(1e-5, 0.1),
               .text = "Time step in √(L/g), L the size of the smallest block that moves and g the "
                       "acceleration of all by their loads; a tenth of it while joints tear."})
      .number("accuracy", &P::accuracy,
              {.bounds = between(1e-9, 0.1),
               .text = "Largest error of a place in a step, in sizes of its block, by how much accelerations "
                       "change within it: steps are as short as that asks for, `step` at most. Without it "
                       "they are as long as `step`, unless one finds no end."})
      .number("frame_every", &P::frame_every,
              {.fallback = 0,
               .bounds = at_least(0),
               .text = "Time between the states that are stored [s]; 0: so much that a hundred are stored to "
                       "two hundred, however early all is at rest."});
}

}  // namespace dda
