#pragma once

#include <string>
#include <utility>
#include <vector>

#include "continuation/path/path.hpp"
#include "support/cracked.hpp"

namespace dda {

/// The guided bar with one softening interface: u(σ) = σL/E + w_c (1 − σ/ft) after the peak.
inline std::string bar_deck(double length) {
  const auto x = [&](double share) { return std::to_string(share * length); };
  return "scene:\n  regions:\n"
         "    - {name: a, material: concrete, vertices: [[0, 0], [" +
         x(0.5) + ", 0], [" + x(0.5) +
         ", 100], [0, 100]]}\n"
         "    - {name: b, material: concrete, vertices: [[" +
         x(0.5) + ", 0], [" + x(1) + ", 0], [" + x(1) + ", 100], [" + x(0.5) +
         ", 100]]}\n"
         "  curves: {crack: [[" +
         x(0.5) + ", 0], [" + x(0.5) +
         ", 100]]}\n"
         "  boundaries: {left: [[0, 0], [0, 100]], right: [[" +
         x(1) + ", 0], [" + x(1) +
         ", 100]]}\n"
         "thickness: 100\nmaterials: {concrete: {type: linear_elastic, young_modulus: 30000, poisson_ratio: "
         "0}}\n"
         "interfaces: {crack: {points: midpoint, law: {type: linear_softening, tensile_strength: 3, "
         "fracture_energy: 0.1}}}\n"
         "supports:\n  wall: {boundary: left, fix: x}\n"
         "  guide_a: {at: [" +
         x(0.25) + ", 50], fix: y}\n  guide_b: {at: [" + x(0.75) +
         ", 50], fix: y}\n"
         "  turn_a: {at: [" +
         x(0.25) + ", 50], fix: rotation}\n  turn_b: {at: [" + x(0.75) +
         ", 50], fix: rotation}\n"
         "stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]\n"
         "gauges: {u: {type: relative_displacement, from: [0, 50], to: [" +
         x(1) + ", 50]}}\n";
}

/// The same without a rupture to land on.
inline std::string endless_bar_deck() {
  const std::string law = "linear_softening";
  std::string out = bar_deck(100);
  return out.replace(out.find(law), law.size(), "exponential_softening");
}

/// A structure on its path.
class OnPath {
 public:
  OnPath(const std::string& deck, const std::string& path_yaml, std::vector<double> landings = {})
      : structure_(deck),
        equilibrium_(structure_.equilibrium()),
        parameters_(path_schema().read(parse_yaml(path_yaml, "path.yaml"))),
        system_(equilibrium_, parameters_.linear, parameters_.update),
        stepper_(system_, parameters_),
        walker_(stepper_),
        book_{system_.loading().gauges, "", "u"},
        path_(walker_, parameters_, book_, Route{wanted(landings)}) {}

  Path& path() { return path_; }
  const Walker& walker() const { return walker_; }
  System& system() { return system_; }
  const Stepper& stepper() const { return stepper_; }
  Stepper& stepper() { return stepper_; }
  /// What the path knows where the walker stands, on another route.
  PathState state(Route route = {}) {
    PathState out(walker_, parameters_, book_, std::move(route));
    out.memory = path_.memory();
    return out;
  }
  const Functional& gauge() const { return book_.gauges.front().functional; }
  double value() const { return walker_.value(book_.gauges.front().functional); }

 private:
  std::vector<Landing> wanted(const std::vector<double>& values) const {
    std::vector<Landing> out;
    for (const double value : values) out.push_back({"u", book_.gauges.front().functional, value, false});
    return out;
  }
  Structure structure_;
  Equilibrium equilibrium_;
  PathParameters parameters_;
  System system_;
  Stepper stepper_;
  Walker walker_;
  GaugeBook book_;
  Path path_;
};

struct Bar : OnPath {
  Bar(double length, const std::string& path_yaml, std::vector<double> landings = {})
      : OnPath(bar_deck(length), path_yaml, std::move(landings)) {}
  double stress() const { return walker().state().load_factor; }
  double elongation() const { return value(); }
};

}  // namespace dda
