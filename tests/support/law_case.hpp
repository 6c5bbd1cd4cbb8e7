#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "framework/deck/document/node.hpp"
#include "models/interface/law.hpp"
#include "models/interface/scaled_law.hpp"
#include "models/interface/water_filled_law.hpp"
#include "support/sample.hpp"

namespace dda {

/// Numbers of what a law remembers under a name.
inline std::span<double> remembered(const InterfaceLaw& law, History& h, const std::string& name) {
  double* at = h.memory.numbers().data();
  for (const Remembered& one : law.memory()) {
    if (one.name == name) return {at, static_cast<std::size_t>(one.size)};
    at += one.size;
  }
  throw std::out_of_range("the law does not remember " + name);
}

/// The first of them.
inline double remembered_number(const InterfaceLaw& law, History h, const std::string& name) {
  return remembered(law, h, name).front();
}

/// A law with the stiffness of a point that can bear it, and the openings at which something happens.
struct LawCase {
  std::unique_ptr<InterfaceLaw> law;
  Node parameters;
  double k = 0;
  double first = 1;        ///< κ at initiation, 1 when there is none [L]
  double last = 5;         ///< κ at rupture, five times the first when there is none [L]
  bool is_filled = false;  ///< by water, as far as it is cracked

  /// The stiffest that the law can answer [F/L³].
  double stiff() const { return k * std::max(1.0, std::pow(law->shear_weight(), 2)); }
  double opening(const Vec2& q, const History& h) const { return law->equivalent_opening(q, h, k); }
  Vec2 traction(const Vec2& q, const History& h) const { return law->respond(q, h, k).traction; }
  /// Whether it resists sliding by its own pressure.
  bool is_frictional() const { return angle("friction_angle") > 0 || angle("residual_friction_angle") > 0; }
  /// Whether the traction while damage grows derives from a potential: no friction, no mode of its own
  /// energy.
  bool has_potential() const {
    return !is_frictional() && !parameters.find("shear_fracture_energy") && !law->releases_at_once() &&
           !is_filled;
  }

  std::string text() const { return to_yaml(parameters); }

  /// A law that releases at once is never met beyond its strength: q drawn back onto it.
  Vec2 admissible(const Vec2& q, const History& h) const {
    const double now = opening(q, h), strength = law->kappa(h, k);
    return law->releases_at_once() && h.share == 0 && now > strength ? Vec2(q * (strength / now)) : q;
  }
  bool must_release(const Vec2& q, const History& h) const {
    return law->releases_at_once() && !law->is_broken(h, k) && opening(q, h) >= law->kappa(h, k) * (1 - 1e-9);
  }
  /// Releases what failed at q, down to the share given; books the energy.
  History released(const Vec2& q, History h, double share) const {
    for (const double part : {0.7, 0.3, 0.0}) {
      h = law->accept(q, law->release(q, h, k, std::max(part, share)), k);
      if (part <= share) break;
    }
    return h;
  }
  /// A history made by accepting random openings, the last perhaps in the midst of a release.
  History reachable(Random& random, int steps = 6) const {
    History h;
    for (int i = 0; i < steps; ++i) {
      const Vec2 q = admissible(random.point(1.3 * (random.coin() ? last : first)), h);
      h = law->accept(q, h, k);
      if (must_release(q, h)) h = released(q, h, i + 1 == steps ? 0.5 : 0);
    }
    return h;
  }

 private:
  double angle(const std::string& name) const {
    const Node* found = parameters.find(name);
    return found ? std::stod(found->text) : 0;
  }
};

/// A random law of the family's member: with what may be absent, or without it.
inline LawCase random_law(const std::string& name, Random& random, bool with_optional,
                          const UnitChange& units = {}) {
  const SchemaBase& schema = *interface_laws().find(name)->schema;
  NameHints hints = with_optional ? optional_numbers(schema, random) : NameHints{};
  if (hints.contains("cohesion"))
    hints.erase(random.coin() ? "cohesion" : "shear_weight");  // one does the other's work
  LawCase out;
  out.parameters = rescaled(sample(schema, random, hints), schema, units);
  // What is released holds no more than the bond did.
  Node* const bond = out.parameters.find("friction_angle");
  Node* const residual = out.parameters.find("residual_friction_angle");
  if (bond && residual && std::stod(residual->text) > std::stod(bond->text)) std::swap(*bond, *residual);
  out.law = interface_laws().choose(name, out.parameters).make();
  const double slope = out.law->steepest_slope(), weight = out.law->shear_weight();
  out.k = random.between(1.5, 5) * (slope > 0 ? slope : units.factor(dimension::interface_stiffness)) /
          std::min(1.0, weight * weight);
  out.first = units.length;
  if (std::isfinite(out.law->initial_kappa(out.k))) out.first = out.law->initial_kappa(out.k);
  out.last = std::isfinite(out.law->rupture_kappa(out.k)) ? out.law->rupture_kappa(out.k) : 5 * out.first;
  return out;
}

/// Strengths × a and energies × a b in the deck.
inline Node scaled_parameters(Node p, double a, double b) {
  for (const std::string name : {"tensile_strength", "cohesion"})
    if (Node* found = p.find(name)) *found = Node::number(a * std::stod(found->text));
  for (const std::string name : {"fracture_energy", "shear_fracture_energy"})
    if (Node* found = p.find(name)) *found = Node::number(a * b * std::stod(found->text));
  return p;
}

/// The same law with its tractions and openings scaled, as a random field scales them from place to place.
inline LawCase scaled(LawCase at, double traction, double opening) {
  at.law = std::make_unique<ScaledLaw>(std::move(at.law), traction, opening);
  at.parameters = scaled_parameters(std::move(at.parameters), traction, opening);
  at.k *= traction / opening;
  at.first *= opening;
  at.last *= opening;
  return at;
}

/// The same law with water in its crack, as much as the stiffness of the point can bear; as it is where it tells no opening.
inline LawCase filled(LawCase at, double share) {
  const auto wide = at.law->widening(0, at.k);
  if (!wide) return at;
  const double opening = 0.7 * at.last, weight = at.law->shear_weight();
  const double spare = at.k * std::min(1.0, weight * weight) - at.law->steepest_slope();
  at.law = std::make_unique<WaterFilledLaw>(std::move(at.law), share * spare * opening / wide->gain, opening);
  at.is_filled = true;
  return at;
}

/// The same law without friction.
inline LawCase without_friction(const std::string& name, LawCase at) {
  for (const std::string angle : {"friction_angle", "residual_friction_angle"})
    if (at.parameters.find(angle)) at.parameters.set(angle, Node::number(0));
  at.law = interface_laws().choose(name, at.parameters).make();
  return at;
}

}  // namespace dda
