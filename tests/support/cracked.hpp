#pragma once

#include "continuation/state/system.hpp"
#include "support/structure.hpp"

namespace dda {

/// Vectors of the size of the unknowns, written as arithmetic.
inline Eigen::Map<const Eigen::VectorXd> vec(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

/// A system on the unit square with a damaged state: some points loading, some unloading, some closed.
class CrackedSystem {
 public:
  explicit CrackedSystem(const std::string& yaml = square_deck(), std::uint64_t seed = 7)
      : structure_(yaml),
        equilibrium_(structure_.equilibrium()),
        system_(equilibrium_, direct_solvers().choose("cholmod"), LinearSystem::Update::low_rank),
        random_(seed) {
    system_.set_stage(equilibrium_.stages().size() - 1);
    // Openings of some ten times that of initiation, ft/k = 0.01/k with k about 10.
    system_.set_history(system_.next_history({random_state(), 0.5}));
    do state_ = {random_state(), 0.7};
    while (near_kink());
  }

  const Structure& structure() const { return structure_; }
  const Equilibrium& equilibrium() const { return equilibrium_; }
  System& system() { return system_; }
  const State& state() const { return state_; }
  Random& random() { return random_; }
  std::vector<double> direction() { return random_.vector(state_.d.size(), 1); }
  /// The state moved along a direction of the unknowns.
  State moved(const std::vector<double>& along, double amount) const {
    State out = state_;
    out.d = out.d.moved(amount, along);
    return out;
  }
  std::vector<double> residual(const State& at) const {
    std::vector<double> out(at.d.size());
    system_.residual(at.d, at.load_factor, system_.laws(at), out);
    return out;
  }
  /// Numbers of points that load, unload and are closed.
  Eigen::Vector3i modes() const {
    Eigen::Vector3i count = Eigen::Vector3i::Zero();
    const LawValues laws = system_.laws(state_);
    for (std::size_t p = 0; p < laws.opening.size(); ++p) {
      const bool loads = equivalent_opening(p, laws) > system_.kappa(p);
      count += Eigen::Vector3i(loads, !loads, laws.opening[p].x() < 0);
    }
    return count;
  }

 private:
  double equivalent_opening(std::size_t p, const LawValues& laws) const {
    const InterfacePoint& point = equilibrium_.point(p);
    return point.law->equivalent_opening(laws.opening[p], system_.history()[p], point.stiffness);
  }
  std::vector<double> random_state() { return random_.vector(equilibrium_.num_unknowns(), 0.004); }
  bool near_kink() const {
    const LawValues laws = system_.laws(state_);
    for (std::size_t p = 0; p < laws.opening.size(); ++p) {
      const InterfacePoint& point = equilibrium_.point(p);
      const double kappa = system_.kappa(p), opening = equivalent_opening(p, laws);
      constexpr double near = 1e-3;
      if (std::abs(laws.opening[p].x()) < near * kappa || std::abs(opening - kappa) < near * kappa ||
          std::abs(opening - point.law->rupture_kappa(point.stiffness)) < near * kappa)
        return true;
    }
    const Eigen::Vector3i count = modes();
    return count.minCoeff() == 0;
  }

  Structure structure_;
  Equilibrium equilibrium_;
  System system_;
  Random random_;
  State state_;
};

/// A dead stage and a reference stage that use every load, initial stress in both.
inline std::string all_loads() {
  return R"(stages:
  - name: dead
    loads:
      - {type: body_force, force: [0.001, -0.003]}
      - {type: initial_stress, xx: -0.002, yy: 0.001, xy: 0.0005}
      - {type: prescribed_displacement, name: pusher, at: [1, 0.2], direction: [0, 1], displacement: 0.001}
  - name: live
    loads:
      - {type: edge_traction, boundary: right, traction: [0.01, 0.002], pressure: 0.001}
      - {type: point_load, at: [0.7, 1], force: [0.001, -0.002]}
      - {type: initial_stress, xx: 0.001, yy: 0.002, xy: -0.001}
      - {type: prescribed_displacement, at: [1, 0.9], direction: [1, 1], displacement: 0.002}
)";
}

/// The square under all loads; its cracks joined by a treatment, their law with `more` keys (YAML).
inline std::string cracked_square(const std::string& treatment, const std::string& more = "") {
  return square_deck(all_loads(), "  joint: {between: [mortar, stone], treatment: " + treatment +
                                      ", law: {type: linear_softening, tensile_strength: 0.01, "
                                      "fracture_energy: 0.0002, shear_weight: 0.8" +
                                      more + "}}\n");
}

}  // namespace dda
