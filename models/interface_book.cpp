#include "models/interface_book.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

/// Exactly closed points cannot open one by one unless each has a corner of its own to move: of two Gauss
/// points on a side, the second holds what the first lets go.
PointRule usual_points(const Treatment& treatment) {
  return treatment.multiplier() == Multiplier::none ? PointRule::gauss : PointRule::vertices;
}

std::pair<std::string, std::string> ordered(std::string a, std::string b) {
  return a < b ? std::pair(std::move(a), std::move(b)) : std::pair(std::move(b), std::move(a));
}

}  // namespace

InterfaceBook::InterfaceBook(const Body& body, const ModelParameters& model, Findings& findings)
    : body_(body), model_(model), findings_(findings) {
  for (const auto& [name, parameters] : model.interfaces) add(name, parameters);
  bond_.law = interface_laws().choose("bonded").make();
  bond_.treatment = treatments().choose("consistent").make();
  for (const CrackParameters& crack : model.cracks) add_crack(crack);
  check_names();
}

void InterfaceBook::add(const std::string& name, const InterfaceParameters& p) {
  Interface made{.name = name,
                 .law = p.law.make(),
                 .treatment = p.treatment.make(),
                 .points = {},
                 .where = p.where,
                 .index = static_cast<int>(interfaces_.size())};
  made.points = p.points.value_or(usual_points(*made.treatment));
  made.second_order_points = p.points.value_or(
      made.treatment->multiplier() == Multiplier::none ? PointRule::gauss : PointRule::gauss_2);
  check_release(p, made);
  if (!p.boundary.empty()) check_plane(p, made);
  if (p.field) add_field(*p.field, made);
  if (p.crack_normal) add_crack_normal(*p.crack_normal, made);
  if (p.water) add_water(*p.water, made);
  if (p.between.empty())
    by_curve_[name] = made.index;
  else
    by_pair_[ordered(p.between[0], p.between[1])] = made.index;
  for (const std::string& material : p.between)
    if (!model_.material_names.contains(material)) findings_.add(p.where, unknown_material(material));
  interfaces_.push_back(std::move(made));
}

void InterfaceBook::add_crack(const CrackParameters& p) {
  std::vector<std::string> known;
  for (const Region& region : body_.assembly.regions) known.push_back(region.name);
  for (const std::string& name : p.through_blocks) {
    const auto region = std::ranges::find(known, name);
    if (region == known.end())
      findings_.add(p.where, fmt::format("unknown region '{}'{}", name, suggest(name, known)));
    else
      add_through(static_cast<int>(region - known.begin()), p);
  }
  for (const std::string& name : p.end_at)
    if (std::ranges::find(interfaces_, name, &Interface::name) == interfaces_.end())
      findings_.add(p.where, fmt::format("`end_at`: unknown interface '{}'{}", name, suggested(name)));
}

std::string InterfaceBook::suggested(const std::string& name) const {
  std::vector<std::string> known;
  for (const Interface& interface : interfaces_) known.push_back(interface.name);
  return suggest(name, known);
}

void InterfaceBook::add_through(int region, const CrackParameters& p) {
  const Region& through = body_.assembly.regions[static_cast<std::size_t>(region)];
  const auto law = law_through(p, through.material);
  if (!law) return;
  const auto before = through_.find(region);
  if (before != through_.end() && (before->second.law != *law || before->second.stiffness != p.stiffness))
    findings_.add(p.where, fmt::format("region '{}' is in two entries of `cracks`, which must agree on its "
                                       "`law` and `stiffness`",
                                       through.name));
  through_[region] = {
      .bond = {.name = "bond", .law = bond_.law, .treatment = interfaces_[*law].treatment, .where = p.where},
      .law = *law,
      .stiffness = p.stiffness};
}

/// The interface that a crack through this material takes.
std::optional<std::size_t> InterfaceBook::law_through(const CrackParameters& p, const std::string& material) {
  const auto by_name = std::ranges::find(interfaces_, p.law, &Interface::name);
  const auto by_pair = by_pair_.find({material, material});
  const bool is_known = p.law.empty() ? by_pair != by_pair_.end() : by_name != interfaces_.end();
  if (!is_known) {
    findings_.add(p.where,
                  p.law.empty()
                      ? fmt::format("cracks through '{0}' need a law: describe the interface between "
                                    "[{0}, {0}], or name one by `law`",
                                    material)
                      : fmt::format("`law`: unknown interface '{}'{}", p.law, suggested(p.law)));
    return {};
  }
  const auto found = p.law.empty() ? static_cast<std::size_t>(by_pair->second)
                                   : static_cast<std::size_t>(by_name - interfaces_.begin());
  const auto& parameters = model_.interfaces[found].second;
  if (parameters.crack_normal)
    findings_.add(
        p.where,
        fmt::format("cracks through blocks run where the stress sends them; the `crack_normal` of the "
                    "interface '{}' is for cracks along sides",
                    interfaces_[found].name));
  if (!std::isfinite(interfaces_[found].law->initial_kappa(1)))
    findings_.add(
        p.where,
        fmt::format("cracks through blocks need a law with a tensile strength; that of the interface "
                    "'{}' is `{}`: name another one by `law`",
                    interfaces_[found].name, parameters.law.name()));
  if (parameters.treatment.name() != "consistent")
    findings_.add(p.where,
                  fmt::format("cracks through blocks need the treatment 'consistent' of the interface '{}'",
                              interfaces_[found].name));
  return found;
}

/// A release holds the trial opening of a point and lets its traction go. A multiplier's traction is not
/// that of its trial opening while the side's other point holds the side: it would pass the envelope
/// unseen.
void InterfaceBook::check_release(const InterfaceParameters& p, const Interface& made) {
  if (made.law->releases_at_once() && made.treatment->multiplier() != Multiplier::none)
    findings_.add(p.where, fmt::format("interface '{}': the law '{}' releases at once, which joints with "
                                       "multipliers ('{}') cannot follow without passing its strength; use "
                                       "the treatment 'consistent' or 'penalty', or a law that softens",
                                       made.name, p.law.name(), p.treatment.name()));
}

void InterfaceBook::check_plane(const InterfaceParameters& p, const Interface& made) {
  if (made.treatment->multiplier() == Multiplier::unknown)
    findings_.add(p.where,
                  fmt::format("interface '{}': on a plane of symmetry nothing slides that the multipliers of "
                              "'{}' could tie; take another treatment",
                              made.name, p.treatment.name()));
}

/// A field that does not vary leaves the law as it is.
void InterfaceBook::add_field(const FieldParameters& field, Interface& interface) {
  if (!std::isfinite(interface.law->initial_kappa(1)))
    return findings_.add(interface.where, "`field` needs a law with a strength that can vary");
  if (field.coefficient_of_variation == 0) return;
  interface.field.emplace(field);
  interface.energy_exponent = field.energy_exponent;
}

void InterfaceBook::add_crack_normal(const Vec2& normal, Interface& interface) {
  if (!std::isfinite(interface.law->initial_kappa(1)))
    findings_.add(interface.where, "`crack_normal` needs a law with a strength");
  interface.crack_normal = normal.normalized();
}

/// It is there before anything moves, so that something must press the bodies together before a load is followed.
void InterfaceBook::add_water_between_bodies(const WaterParameters& water, Interface& interface) {
  interface.water = water;
  interface.water->opening = 0;
  if (water.opening)
    findings_.add(
        interface.where,
        "`opening` of `water` is that of a crack: between bodies that only touch all of it is there from "
        "the beginning");
  if (model_.num_dead_stages() == 0)
    findings_.add(
        interface.where,
        "`water` between bodies that only touch parts them unless something presses on them: a stage "
        "that is applied in full, as their weight, comes first");
}

void InterfaceBook::add_water(const WaterParameters& water, Interface& interface) {
  if (interface.law->contact({}, 1)) return add_water_between_bodies(water, interface);
  if (!interface.law->can_crack() || !interface.law->widening(0, 1))
    return findings_.add(
        interface.where,
        "`water` needs a law that softens, whose crack it presses on, or one of bodies that only touch");
  interface.water = water;
  if (water.opening) return;
  const double end = interface.law->rupture_kappa(1);
  if (!std::isfinite(end))
    return findings_.add(interface.where,
                         "`water` needs its `opening`: the traction of this law never vanishes");
  interface.water->opening = end;
}

void InterfaceBook::check_names() {
  const auto& curves = body_.assembly.curves;
  for (const auto& [name, index] : by_curve_)
    if (std::ranges::find(curves, name) == curves.end())
      findings_.add(
          interfaces_[static_cast<std::size_t>(index)].where,
          fmt::format("the scene has no interface curve '{}'{}; or give `between: [a, b]` for a pair of "
                      "materials",
                      name, suggest(name, curves)));
  for (const std::string& curve : curves)
    if (!by_curve_.contains(curve))
      findings_.add(
          model_.where,
          fmt::format("the scene names an interface '{}' that `interfaces` does not describe", curve));
}

std::string InterfaceBook::unknown_material(const std::string& name) const {
  std::vector<std::string> known;
  for (const auto& [known_name, choice] : model_.material_names) known.push_back(known_name);
  return fmt::format("unknown material '{}'{}", name, suggest(name, known));
}

Interface& InterfaceBook::of_side(const Side& side) {
  if (side.curve)
    if (const auto found = by_curve_.find(body_.assembly.curves[static_cast<std::size_t>(*side.curve)]);
        found != by_curve_.end())
      return interfaces_[static_cast<std::size_t>(found->second)];
  const int region = body_.block(side.first).region;
  if (const auto inner = through_.find(region);
      inner != through_.end() && body_.block(side.second).region == region)
    return inner->second.bond;
  const auto found = by_pair_.find(ordered(material_name(side.first), material_name(side.second)));
  return found != by_pair_.end() ? interfaces_[static_cast<std::size_t>(found->second)] : bond_;
}

}  // namespace dda
