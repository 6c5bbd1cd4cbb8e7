#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "continuation/handover/drawn_overlaps.hpp"
#include "continuation/handover/handover.hpp"
#include "continuation/handover/regions.hpp"
#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

/// Names of what the structure has not got are findings.
class NameCheck {
 public:
  NameCheck(const Body& body, Findings& findings) : findings_(findings) {
    for (const Region& region : body.assembly.regions) {
      regions_.push_back(region.name);
      materials_.push_back(region.material);
    }
  }
  void regions(const Position& where, const std::string& key, const std::vector<std::string>& names) {
    check(where, key + ": there is no region '", names, regions_);
  }
  void materials(const Position& where, const std::string& key, const std::vector<std::string>& names) {
    check(where, key + ": no region is of material '", names, materials_);
  }

 private:
  void check(const Position& where, const std::string& what, const std::vector<std::string>& names,
             const std::vector<std::string>& known) {
    for (const std::string& name : names)
      if (std::ranges::find(known, name) == known.end())
        findings_.add(where, what + name + "'" + suggest(name, known));
  }

  Findings& findings_;
  std::vector<std::string> regions_, materials_;
};

void check_names(const Body& body, const MotionParameters& parameters, Findings& findings) {
  NameCheck check(body, findings);
  for (std::size_t i = 0; i < parameters.held.names.size(); ++i)
    check.regions(parameters.held.where[i], "motion.held", {parameters.held.names[i]});
  for (const DriveParameters& drive : parameters.driven)
    check.regions(drive.where, "motion.driven", drive.regions);
  std::set<std::size_t> given;
  for (const VelocityParameters& thrown : parameters.velocities) {
    check.regions(thrown.where, "motion.velocities", thrown.regions);
    for (std::size_t r = 0; r < body.assembly.regions.size(); ++r) {
      const int region = static_cast<int>(r);
      if (!is_named(thrown.regions, body, region)) continue;
      const std::string name = "motion.velocities: region '" + body.assembly.regions[r].name + "' ";
      if (!given.insert(r).second)
        findings.add(thrown.where, name + "has a velocity by another entry; give it one");
      if (is_held(body, parameters, region)) findings.add(thrown.where, name + "is held");
    }
  }
  for (const PairParameters& pair : parameters.contact.pairs)
    check.materials(pair.where, "motion.contact.pairs", pair.between);
}

void check_density(const Body& body, const MotionParameters& parameters, const ModelParameters& model,
                   Findings& findings) {
  std::set<std::string> without;
  for (std::size_t r = 0; r < body.assembly.regions.size(); ++r)
    if (!is_held(body, parameters, static_cast<int>(r)) && body.materials[r]->density() <= 0)
      without.insert(body.assembly.regions[r].material);
  for (const std::string& material : without)
    findings.add(model.material_names.at(material).where(),
                 "motion: material '" + material + "' needs a `density`");
}

void check_offset(const Body& body, const MotionParameters& parameters, Findings& findings) {
  if (const auto narrow = too_narrow(body.assembly, offset_of(body, parameters)))
    findings.add(parameters.where, "motion.contact.offset: " + *narrow + "; take a smaller offset");
}

/// Bodies that begin inside each other would be pressed apart, by an energy that nothing has given them.
void check_overlaps(const Body& body, const MotionParameters& parameters, Findings& findings) {
  const auto name = [&](std::size_t block) {
    return body.assembly.regions[static_cast<std::size_t>(body.assembly.blocks[block].region)].name;
  };
  for (const DrawnOverlap& overlap : drawn_overlaps(body, parameters))
    if (overlap.depth > overlap.touching)
      findings.add(
          parameters.where,
          fmt::format("motion: block {} of region '{}' and block {} of region '{}' overlap by {:.3g} at "
                      "({:.6g}, {:.6g}), deeper than {:.3g}, which drawings are rounded by; draw them "
                      "side by side",
                      overlap.first, name(overlap.first), overlap.second, name(overlap.second), overlap.depth,
                      overlap.at.x(), overlap.at.y(), overlap.touching));
}

/// What an integrator that opens and closes contacts has no way to do.
void check_open_close(const Equilibrium& equilibrium, const MotionParameters& parameters,
                      Findings& findings) {
  const std::unique_ptr<Integrator> integrator = parameters.integrator.make();
  if (!integrator->open_close()) return;
  const MeetingParameters& contact = parameters.contact;
  const auto gives_back = [](const PairParameters& pair) { return pair.restitution.value_or(0) > 0; };
  const std::string name = "'" + parameters.integrator.name() + "'";
  if (contact.restitution > 0 || std::ranges::any_of(contact.pairs, gives_back))
    findings.add(parameters.where, "motion.contact.restitution: " + name +
                                       " has none; how bodies rebound hangs on its penalty and step");
  bool is_joined = false;
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p)
    is_joined = is_joined || !equilibrium.point(p).is_separate();
  if (integrator->grows() && is_joined)
    findings.add(parameters.where, "motion.integrator: " + name +
                                       " with rotations in first order is for blocks that nothing joins");
}

/// Of the first region that is named as held or driven.
const Position& place_of_held(const MotionParameters& parameters) {
  if (!parameters.held.where.empty()) return parameters.held.where.front();
  return parameters.driven.empty() ? parameters.where : parameters.driven.front().where;
}

/// What one without inertia, or one whose steps are no minimum, has not.
void check_integrator(const MotionParameters& parameters, Findings& findings) {
  const Position& where = parameters.where;
  const auto integrator = parameters.integrator.make();
  if (parameters.damping.is_any() && !integrator->has_inertia())
    findings.add(
        where, "motion.damping: '" + parameters.integrator.name() + "' has no velocities that it could damp");
  if (parameters.damping.is_any() && integrator->open_close())
    findings.add(where, "motion.damping: '" + parameters.integrator.name() +
                            "' is damped by the share of the velocity that it keeps, `velocity_kept`");
  if (parameters.accuracy && (!integrator->has_inertia() || integrator->open_close()))
    findings.add(where, "motion.accuracy: '" + parameters.integrator.name() +
                            "' tells no accelerations by which an error could be judged; give a `step`");
  if (!parameters.velocities.empty() && !integrator->has_inertia())
    findings.add(where, "motion.velocities: '" + parameters.integrator.name() + "' knows of no velocities");
}

/// Whether what is driven can be, as far as its way can be told before.
void check_drives(const MotionParameters& parameters, Findings& findings) {
  constexpr int looks = 1000;
  for (const DriveParameters& drive : parameters.driven) {
    try {
      const auto displacement = drive.displacement.make();
      for (int look = 0; look <= looks && parameters.time > 0; ++look)
        displacement->at(parameters.time * look / looks);
    } catch (const InputError& error) {
      findings.add(error);
    }
  }
}

/// A path may leave loads that pull; without one gravity alone does.
void check_time(const ModelParameters& model, const MotionParameters& parameters, Findings& findings) {
  if (parameters.time > 0) return;
  if (!parameters.stops_at_rest)
    findings.add(parameters.where,
                 "motion.time: without `stop_at_rest` a motion needs to be told how long it is");
  else if (model.stages.empty() && parameters.gravity.isZero(0))
    findings.add(parameters.where, nothing_pulls);
}

}  // namespace

void require_handover(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters,
                      const ModelParameters& model) {
  const Position& where = parameters.where;
  Findings findings;
  if (!friction_of_others(equilibrium.interfaces(), parameters) && !pairs_tell_all(body, parameters) &&
      !is_one_convex_body(body, equilibrium.interfaces()))
    findings.add(
        parameters.contact.where,
        "motion.contact.friction: no interface tells, or not all of them the same; give that of bodies "
        "which meet");
  check_time(model, parameters, findings);
  if (parameters.loads == KeptLoads::dead && !equilibrium.driven_springs().empty())
    findings.add(where, "motion.loads: what is driven stays where it is, `keep`");
  check_integrator(parameters, findings);
  if (std::ranges::all_of(body.assembly.blocks,
                          [&](const Block& block) { return is_held(body, parameters, block.region); }))
    findings.add(place_of_held(parameters), "motion.held: nothing is left that could move");
  check_drives(parameters, findings);
  check_open_close(equilibrium, parameters, findings);
  check_names(body, parameters, findings);
  check_density(body, parameters, model, findings);
  check_offset(body, parameters, findings);
  check_overlaps(body, parameters, findings);
  findings.throw_if_any();
}

}  // namespace dda
