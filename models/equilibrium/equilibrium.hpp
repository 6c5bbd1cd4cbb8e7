#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "models/body/block_matrix.hpp"
#include "models/body/functional.hpp"
#include "models/equilibrium/support.hpp"
#include "models/interface_point.hpp"

namespace dda {

/// A named scalar recorded at every step.
struct NamedGauge {
  std::string name;
  Functional functional;
  Dimension dimension;
};

/// External work of one driven spring: ∫ force d(displacement).
struct WorkPair {
  Functional force, displacement;
};

/// The loads of one stage with everything before it at full value.
///
///     f(λ) = dead + λ reference          size 6 · blocks
///     q0(λ) = dead_offset + λ reference_offset    2 per active point, from initial stress; empty when
///     there is none
struct Loading {
  std::string name;
  std::vector<double> dead, reference;
  std::vector<double> dead_offset, reference_offset;
  /// The parts of `dead` and `reference` that are forces, not the far ends of driven springs: they do the
  /// work.
  std::vector<double> dead_work, reference_work;
  std::vector<WorkPair> driven;

  /// q0 of an active point at λ = 0, and its rate in λ [L].
  Vec2 dead_opening(std::size_t p) const { return part_of(dead_offset, p); }
  Vec2 reference_opening(std::size_t p) const { return part_of(reference_offset, p); }
  /// Stress that is there without strain, by block; empty when there is none [F/L²].
  std::vector<Vec3> dead_stress, reference_stress;
  std::vector<double> dead_out_of_plane, reference_out_of_plane;  ///< see StageLoads
  Vec3 initial_stress(std::size_t block, double load_factor) const {
    const auto part = [&](const std::vector<Vec3>& of) {
      return of.empty() ? Vec3(Vec3::Zero()) : of[block];
    };
    return part(dead_stress) + load_factor * part(reference_stress);
  }
  double out_of_plane(std::size_t block, double load_factor) const {
    const auto part = [&](const std::vector<double>& of) { return of.empty() ? 0 : of[block]; };
    return part(dead_out_of_plane) + load_factor * part(reference_out_of_plane);
  }
  Functional load;             ///< the load gauge: λ Σ|force|, or the sum of the driven reactions
  bool load_is_force = true;   ///< else it is λ itself, of loads without a resultant
  bool all_are_forces = true;  ///< the load of every followed stage
  std::map<std::string, Reaction> reactions;  ///< by support and driven spring
  std::vector<NamedGauge> gauges;             ///< as the deck names them

 private:
  static Vec2 part_of(const std::vector<double>& offset, std::size_t p) {
    return offset.empty() ? Vec2::Zero() : Vec2(offset[2 * p], offset[2 * p + 1]);
  }
};

/// What the followed stages have left behind.
struct StageHistory {
  std::vector<double> held_load_factors;  ///< of those that are over
  std::vector<double> rest;               ///< of the springs that have been put in since [L]
  std::vector<double> borne;              ///< by those that have been taken away, when that began [F]
};

/// What becomes of springs of supports when a stage begins: where those that it puts in are at rest [L], what those that it
/// takes away bear [F], and the energy in them [FL].
struct SupportChange {
  std::vector<double> rest, borne;
  double energy = 0;
};

/// Equilibrium of the blocks: four operators, nothing about solvers.
///
///     intact   K0 = K_b + Bᵀ W D0 B         constant, symmetric; positive definite without multipliers
///     opening  q = B d + q0(λ)              2 per active point [L]
///     residual R = K0 d + Bᵀ W (t(q; h) − D0 B d) − f(λ)        size 6 · nodes
///     tangent  K = K0 + Bᵀ W (D − D0) B
///
/// K_b holds strain energy, springs and, for consistent joints, −Sᵀ W P⁻¹ S with S d = {σ}n. Nodes are the
/// blocks, behind them the strain gradients of blocks of second order and the jumps across cuts (motion.hpp), and behind
/// these, for Lagrange joints, one node of
/// multipliers per side, m in columns 0-1 and 2-3.
/// Only active points are asked at run time: those that can crack or iterate a multiplier. Bonds are part of
/// K0.
class Equilibrium {
 public:
  Equilibrium(const Body& body, const ModelParameters& model, StageHistory history = {})
      : Equilibrium(body, model, std::move(history), {}) {}
  /// Made anew for the cuts that the body has now. References to it and to its stages stay good, those to points,
  /// springs and laws do not. Whether K0 of the blocks is still the same, but for rounding.
  bool remake(const Body& body, const ModelParameters& model);
  /// Ends the stage that is followed: its loads become dead at this load factor, and the first of `later_stages` takes its
  /// place at the back of `stages`, to which references stay good.
  void hold(const Body& body, const ModelParameters& model, double load_factor);
  /// Takes over the last stage of the model, which has come behind all others since: it is the only one of `later_stages`. Throws
  /// InputError for one with springs of its own, whose stiffness would be another; nothing has changed then.
  void append_stage(const Body& body, const ModelParameters& model);
  /// Place of the stage that is followed among those with loads.
  std::size_t present_stage() const { return num_dead_stages_ + history_.held_load_factors.size(); }
  /// Springs that the stage which is followed puts in and takes away, when it has not done so.
  std::span<const ChangingSpring> springs_to_add() const { return due(added_, history_.rest.size()); }
  std::span<const ChangingSpring> springs_to_remove() const { return due(removed_, history_.borne.size()); }
  /// The change at some displacements.
  SupportChange support_change(std::span<const double> d) const;
  /// Makes it: K0 is another one, and forces stand for what is gone. References stay good as `remake` says.
  void change_supports(const Body& body, const ModelParameters& model, const SupportChange& change);

  std::size_t num_blocks() const { return num_blocks_; }
  /// Of blocks of second order.
  std::size_t num_gradients() const { return gradients_.size(); }
  std::size_t num_jumps() const { return num_jumps_; }
  /// Of cracks through blocks and along their sides.
  std::size_t num_cuts() const { return num_cuts_; }
  /// Blocks and gradients, whose nodes stay when cuts are added; with the jumps, what comes before multipliers.
  std::size_t num_block_nodes() const { return num_blocks_ + num_gradients(); }
  std::size_t num_leading() const { return num_block_nodes() + num_jumps_; }
  std::size_t num_nodes() const { return num_leading() + set_.num_nodes; }
  std::size_t num_unknowns() const { return block_unknowns * num_nodes(); }
  std::size_t num_points() const { return set_.points.size(); }
  /// Points 0 … num_active()−1 are asked at run time; the operators below act on these.
  std::size_t num_active() const { return set_.num_active; }
  const InterfaceSet& interfaces() const { return set_; }
  const InterfacePoint& point(std::size_t p) const { return set_.points[p]; }
  const BlockMatrix& intact() const { return intact_; }
  /// K0 without the joints of bodies that only touch. Across a slide K0 d would sum up and take off again
  /// what springs would bear there, and leave the rounding of that in a residual.
  const BlockMatrix& unjoined() const { return unjoined_ ? *unjoined_ : intact_; }
  /// diag of a point's joint in it [F/L³].
  Vec2 unjoined_stiffness(std::size_t p) const {
    return unjoined_ && point(p).is_separate() ? Vec2::Zero().eval() : point(p).intact_stiffness();
  }
  /// Whether some bodies only touch.
  bool has_separate_bodies() const { return unjoined_.has_value(); }
  /// K0 without the perturbation δ of unknown multipliers: singular once for each redundant one.
  BlockMatrix unperturbed() const;
  std::size_t num_unknown_multipliers() const { return num_unknown_multipliers_; }
  /// Those applied in full, and behind them the one whose loads are followed.
  const std::vector<Loading>& stages() const { return stages_; }
  /// Those that are followed after it.
  const std::vector<Loading>& later_stages() const { return later_stages_; }
  /// Of the followed stages that are over.
  const std::vector<double>& held_load_factors() const { return history_.held_load_factors; }
  const StageHistory& history() const { return history_; }
  /// Length scale of each block, √area [L]: makes rotations and strains comparable with translations.
  const std::vector<double>& block_size() const { return block_size_; }
  /// Diagonal of the box around all blocks [L].
  double extent() const { return extent_; }
  /// V C of each block, 3 × 3: stress resultants from strains [F L].
  const std::vector<Mat3>& strain_stiffness() const { return strain_stiffness_; }
  /// The strain gradient of a block of second order, and its stiffness t C ⊗ S/area (kinematics/second_order.hpp) [F L].
  struct Gradient {
    BlockId block;
    Mat6 stiffness;
  };
  /// In the order of their nodes, behind the blocks.
  const std::vector<Gradient>& gradients() const { return gradients_; }
  /// Where the unknowns of a node are strains: the size of its block [L]; none where they are lengths, of a jump or of
  /// multipliers.
  std::optional<double> strain_size(std::size_t node) const {
    if (node < num_blocks_) return block_size_[node];
    if (node < num_block_nodes()) return block_size_[gradients_[node - num_blocks_].block.value()];
    return {};
  }

  /// q = B d + q0(λ); q of size 2 · num_active().
  void gather(const Loading& loading, std::span<const double> d, double load_factor,
              std::span<double> q) const;
  /// q = B d without offsets, for directions.
  void gather(std::span<const double> d, std::span<double> q) const;
  /// f += Bᵀ W t for the points given; t of size 2 · num_active().
  void scatter_add(std::span<const double> t, std::span<double> f) const;
  /// One point's opening from its rows.
  Vec2 opening(std::size_t p, std::span<const double> d) const;
  /// e·q of a point as a gauge, but for its constant part.
  Functional opening_gauge(const Loading& loading, std::size_t p, const Vec2& e) const;

  /// out += |K0| |d| + Σ W |B|ᵀ D0 |B| |d|: of all products that K0 d sums up, those included which cancel in
  /// K0 itself by the symmetry of a block.
  void add_absolute_products(std::span<const double> d, std::span<double> out) const;
  /// What rounding may leave of a row of K0 d, in units of these products, by node: (4 + √n) ε where n points
  /// are joined to a block, their products being summed one after another.
  const std::vector<double>& rounding_of_sums() const { return rounding_of_sums_; }
  /// out −= Kʷ d: what the weak springs bear.
  void subtract_weak_forces(std::span<const double> d, std::span<double> out) const;
  /// Energy stored in blocks, bonds and supports, weak springs being no part of the structure: all but the
  /// joints of active points and the springs that loads drive [FL]. A sum over the parts: ½ d·K0 d would lose
  /// the digits of a small part of a structure that moves far.
  double passive_energy(std::span<const double> d) const;
  /// Energy of the strain gradients, a part of it [FL].
  double gradient_energy(std::span<const double> d) const;
  /// Energy stored in the weak springs [FL].
  double weak_energy(std::span<const double> d) const;
  /// The springs that loads drive.
  const std::vector<Spring>& driven_springs() const { return driven_; }
  /// The springs that hold the structure now, and all that do at some stage.
  const std::vector<Spring>& supports() const { return supports_; }
  const std::vector<Spring>& all_supports() const { return all_supports_; }
  /// Those that stages put in and take away, in their order; among the supports by now or not.
  const std::vector<ChangingSpring>& added_springs() const { return added_; }
  const std::vector<ChangingSpring>& removed_springs() const { return removed_; }
  /// Of the weak springs at each centroid: p_w for u0 and v0 [F/L], p_w · area for r0 [FL].
  double weak_stiffness() const { return weak_stiffness_; }
  /// Of unknowns that nothing uses, each held by itself.
  double held_stiffness() const { return held_stiffness_; }

 private:
  /// With points that are made already.
  Equilibrium(const Body& body, const ModelParameters& model, StageHistory history,
              std::optional<InterfaceSet> points);
  /// Those that change in the stage that is followed, or have been due before; but for the first, whose change is made.
  std::span<const ChangingSpring> due(const std::vector<ChangingSpring>& springs, std::size_t num_done) const;
  /// The springs of supports that are there once so many have been put in and taken away.
  std::vector<Spring> supports_after(std::size_t num_added, std::size_t num_removed) const;
  void check_supports(const Body& body, const ModelParameters& model, Findings& findings) const;
  void assemble(const Body& body, const ModelParameters& model, const std::vector<Spring>& springs);
  /// Gives the forces of all stages a place for every unknown.
  void fit_stages();
  void add_strain_energy(const Body& body);
  void add_spring(const Spring& spring);
  void hold_unused_unknowns();
  void join_what_touches();
  void estimate_rounding();
  /// What a point adds to twice the passive energy.
  double twice_passive_energy(std::size_t p, std::span<const double> d) const;

  std::size_t num_blocks_, num_jumps_, num_cuts_;
  InterfaceSet set_;
  std::size_t num_unknown_multipliers_ = 0;
  std::vector<Spring> all_supports_, supports_, driven_;
  std::vector<ChangingSpring> added_, removed_;
  double weak_stiffness_ = 0;  ///< of the weak springs [F/L]
  double held_stiffness_ = 0;
  std::vector<std::size_t> held_;  ///< unknowns of nodes that nothing uses
  BlockMatrix intact_;
  std::optional<BlockMatrix> unjoined_;  ///< none where it is K0
  std::vector<Loading> stages_, later_stages_;
  StageHistory history_;
  std::size_t num_dead_stages_ = 0;
  std::vector<double> block_size_, rounding_of_sums_;
  double extent_ = 0;
  std::vector<Mat3> strain_stiffness_;
  std::vector<Gradient> gradients_;
};

/// K += W Sᵀ P⁻¹ S, S d = {σ}n: gives back what a consistent joint subtracts, once nothing is left of it.
void add_stress_energy(BlockMatrix& matrix, const InterfacePoint& point);

}  // namespace dda
