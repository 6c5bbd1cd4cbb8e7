#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "continuation/linear/linear_system.hpp"
#include "models/crack/growth.hpp"

namespace dda {

/// A state of the structure: displacements and load factor of one stage.
struct State {
  Displacements d;
  double load_factor = 0;
  std::vector<Vec2> multipliers = {};  ///< m of every active point when some are iterated, else empty [L]

  double value(const Functional& gauge) const { return d.value(gauge, load_factor); }
};

/// An equilibrium with the history that belongs to it.
struct Settled {
  State state;
  std::vector<History> history;
  int iterations = 0;  ///< that led to it: Newton's, or steps from crack to crack of sequentially linear ones
};

/// What the laws say at a state.
struct LawValues {
  std::vector<Vec2> opening;   ///< q
  std::vector<Vec2> traction;  ///< t
  std::vector<Mat2> tangent;   ///< D

  /// Whether a point has nothing left: it bears no traction, and would bear none if it opened further.
  bool is_released(std::size_t p) const { return traction[p].isZero(0) && tangent[p].isZero(0); }
};

/// Which inner product a v · w an arc length measures steps with: displacements with rotations and strains
/// times the block's size, or the openings of the points that can crack, Σ W q·q.
enum class Metric { natural, openings };

/// The equilibrium of a stage with what it remembers, history and multipliers: one for all equations of a run.
///
///     R(d, λ) = K0 d + Bᵀ W (t(q; h) − D0 B d) − f(λ),      K = K0 + Bᵀ W (D − D0) B
///
/// Iterated multipliers m enter as q = B d + q0(λ) + m and stay during a solve (`set_multipliers`).
/// The history changes only by `set_history`, between solves; what is solved keeps no memory of its own.
/// With `frozen` damage the laws answer with their secant at that history (event control).
class System {
 public:
  /// Factorises the intact stiffness. Throws InputError where that is singular, or needs more memory than there
  /// is.
  System(const Equilibrium& equilibrium, const DirectSolverChoice& solver, LinearSystem::Update update);
  /// Lets the equilibrium be made anew, with other cuts, and follows: cuts that are still there keep their history.
  Growth follow(const std::function<Growth()>& remake);
  /// Times the phases of a step there from now on.
  void measure_with(Timings& timings);
  /// What they are timed with.
  Timings& timings() const { return *timings_; }

  const Equilibrium& equilibrium() const { return equilibrium_; }
  const Loading& loading() const { return *loading_; }
  void set_stage(std::size_t stage);
  /// The base on which contacts are solved, made when it is asked for: always symmetric, with contact of
  /// separate bodies closed and held.
  LinearSystem& contact_linear();
  /// The same if it has been made.
  const LinearSystem* made_contact_linear() const { return contact_.get(); }
  /// Whether some joint is in contact without being bonded, or has cracked.
  bool has_contacts() const;
  /// Whether bodies are joined by contact from the start.
  bool joins_by_contact() const { return joins_by_contact_; }
  LinearSystem& linear() { return linear_; }
  const LinearSystem& linear() const { return linear_; }
  const std::vector<History>& history() const { return history_; }
  void set_history(std::vector<History> history);
  bool frozen() const { return frozen_; }
  void set_frozen(bool frozen);

  /// Whether any joint's multiplier is iterated.
  bool iterates_multipliers() const { return !multipliers_.empty(); }
  const std::vector<Vec2>& multipliers() const { return multipliers_; }
  void set_multipliers(const std::vector<Vec2>& m);
  /// P⁻¹ t/(1 + δ) of the iterated points: what their multipliers are to become, m of the others.
  std::vector<Vec2> next_multipliers(const LawValues& laws) const;
  /// Largest |P⁻¹ t/(1 + δ) − m| in units of the largest t/(E/h), the shortening of a block under its
  /// traction.
  double relative_gap(const LawValues& laws) const;

  /// The stiffness by which the path goes on: K, but with the physical stiffness p̄ of joints whose k is only
  /// a device of the iteration, D̄ = D (1 + (P̄⁻¹ − P⁻¹) D)⁻¹. False when it is singular.
  bool use_path_tangent(const LawValues& laws);
  /// Tangents of all points, bonds among them, symmetric; with each joint's own stiffness p̄ on request.
  std::vector<Mat2> all_tangents(const LawValues& laws, bool is_physical) const;
  /// The stiffness K* of the structure without devices of the method: joints with their own stiffness, released
  /// points with none, and without what consistent joints subtract there.
  BlockMatrix physical_stiffness(const LawValues& laws) const;
  /// Whether the path's tangent is that matrix.
  bool is_path_physical(const LawValues& laws) const;
  LinearSystem& path_linear() { return physical_ ? *physical_ : linear_; }
  const LinearSystem& path_linear() const { return physical_ ? *physical_ : linear_; }
  /// q of a point whose joint opens by g under the path tangent in use: with its multiplier
  /// (P⁻¹ − P̄⁻¹) D̄ g if that is iterated, so that D q = D̄ g.
  Vec2 with_multiplier(std::size_t p, const Vec2& g) const;
  /// Rate of q at a point when d moves by `d` under the path tangent in use.
  Vec2 opening_rate(std::size_t p, std::span<const double> d) const {
    return with_multiplier(p, equilibrium_.opening(p, d));
  }
  Vec2 opening_rate(std::size_t p, const Displacements& d) const { return with_multiplier(p, jump(p, d)); }
  /// B d of an active point.
  Vec2 jump(std::size_t p, const Displacements& d) const {
    return d.sum() ? d.sum()->openings()[p] : equilibrium_.opening(p, d.all());
  }
  /// q̇ of all points where one of them carries a traction `t` more than its tangent says, under the path
  /// tangent in use.
  std::vector<Vec2> opened_by(std::size_t p, const Vec2& t);
  /// −cᵢ · q̇ᵢ that the force of each hinge gives; nothing where it takes solutions (`opened_by`): beside
  /// iterated multipliers and where the linear system has no columns for them.
  std::optional<Eigen::MatrixXd> flexibility(std::span<const LinearSystem::Hinge> hinges);
  /// Rates of the multipliers for the same movement; empty when none is iterated.
  std::vector<Vec2> multiplier_rates(const Displacements& d) const;
  /// What the finite p̄ leaves open when d moves by `d` and the joints by `carried` beside: P̄⁻¹ D̄ (g +
  /// carried) of the iterated points, none of the others and of those whose stiffness p̄ is their own (δ > 0).
  std::vector<Vec2> left_open(std::span<const double> d, std::span<const Vec2> carried) const;
  /// force ← force − Bᵀ W D̄ carried.
  void subtract_carried(std::span<const Vec2> carried, std::span<double> force) const;

  /// Laws at (d, λ) with the committed history, or the given one.
  LawValues laws(std::span<const double> d, double load_factor) const;
  LawValues laws(const State& at) const { return laws_of(openings(at.d, at.load_factor)); }
  /// The same, remembered: equations and control of one Newton iteration ask at the same place.
  std::shared_ptr<const LawValues> laws_at(std::span<const double> d, double load_factor);
  std::shared_ptr<const LawValues> laws_at(const State& at);
  /// The residual R, size n.
  void residual(std::span<const double> d, double load_factor, const LawValues& laws,
                std::span<double> out) const;
  /// K_base⁻¹ R by what is kept of earlier solves; false when that is not enough
  /// (LinearSystem::solve_base_residual).
  bool solve_base_residual(std::span<const double> d, double load_factor, const LawValues& laws,
                           std::span<double> y);
  /// ∂R/∂λ, size n.
  void load_derivative(const LawValues& laws, std::span<double> out) const;
  /// −K⁻¹ ∂R/∂λ with the path tangent in use.
  Displacements load_direction(const LawValues& laws);

  /// Answers of intact points for which no law was asked, so far.
  std::int64_t num_screened() const { return num_screened_; }

  /// What the law of a point says at q, its damage frozen or not.
  Response respond(std::size_t p, const Vec2& q) const;

  /// A number for a new tangent, and its placement in the linear system. False when it is singular.
  std::size_t new_stamp() { return ++stamps_; }
  bool use_tangent(std::size_t stamp, std::span<const Mat2> tangents);

  /// Symmetric part of the tangent stiffness K at a state, with the committed history.
  BlockMatrix stiffness(const State& state) const;

  /// v ← W v of the metric.
  void apply_metric(Metric metric, std::span<double> v) const;

  /// ‖R‖ with moments and stress resultants divided by the blocks' size [F].
  double residual_norm(std::span<const double> r) const;
  /// What a node adds to its square.
  double square_of_residual(BlockId node, const Vec6& r) const;
  /// What is left of R beyond rounding, over the force level: each row may keep (4 + √n) ε of the absolute
  /// products that it sums up (Equilibrium::add_absolute_products, |f|), by which they cannot cancel better.
  /// Stiff joints and supports of blocks that move far make that large. The smaller of two: with the weak
  /// springs, and without them, the structure's own equations.
  double excess_residual(std::span<const double> r, std::span<const double> d, double load_factor) const;
  /// The same at a state.
  double excess_residual(const State& at);
  /// What rounding leaves of the work on a step: Σ (4 + √n) ε |f|ᵢ |Δdᵢ|, with the absolute products |f| at
  /// its end [FL].
  double rounding_of_work(const State& from, const State& to) const;
  /// Σ |force| of the weak springs of all blocks [F].
  double weak_forces(std::span<const double> d) const;
  /// ‖R‖ over the force level; 0 of nothing.
  double relative(double residual_norm, std::span<const double> d) const;
  /// The force level that a residual is compared with: ‖V C ε / size‖ over the blocks, at least a tenth of
  /// the largest that was accepted so far, so that an unloaded end of the path can still be reached [F].
  double force_level(std::span<const double> d) const;
  /// The least that the force level is at any state [F].
  double least_force_level() const { return force_level_floor * highest_level_; }
  void remember_force_level(std::span<const double> d) {
    highest_level_ = std::max(highest_level_, block_forces(d));
  }
  double highest_force_level() const { return highest_level_; }
  void restore_force_level(double level) { highest_level_ = level; }

  /// History after accepting a state: κ grows to q_eq, points on their surface are marked as loading.
  std::vector<History> next_history(const State& at) const;
  /// κ of a point in the committed history, at least that of its initiation [L].
  double kappa(std::size_t p) const { return kappa(p, history_[p]); }
  double kappa(std::size_t p, const History& h) const;
  bool is_broken(std::size_t p) const;
  /// Whether next to nothing is left of it.
  bool is_spent(std::size_t p) const;
  /// Whether any joint that was one has lost some of its strength.
  bool is_damaged() const;

  /// A number that tells apart which points load, are closed or ruptured at these openings.
  std::size_t active_set(const LawValues& laws) const;

  /// Σ W h.dissipated [FL].
  double dissipated(const std::vector<History>& history) const;
  /// Work that water in the cracks has done up to a history [F·L].
  double supplied_by_water(const std::vector<History>& history) const;
  /// Energy stored in blocks, joints, supports and, but where bodies only touch, whose equilibrium is without them,
  /// weak springs; without the driven springs' own [FL].
  double stored(const State& state, const LawValues& laws) const;
  /// Σ |force| of loads and driven springs [F].
  double sum_of_forces(const State& at) const;
  /// What the loads are on blocks, each by its size: couples, and all that they do, which stretches and bends them too [F].
  struct LoadSizes {
    double couples = 0, all = 0;
  };
  LoadSizes load_sizes(const State& at) const;
  /// How far the live and the dead loads have moved, each as one: |f · d| / Σ |f|; the farthest of these and of
  /// the driven ends of springs [L].
  double movement_of_loads(const State& at) const;
  /// f_ref · d of the forces that do work.
  const Functional& reference_work() const { return reference_work_; }
  /// f_dead · d of the forces that do work, without the far ends of driven springs [FL].
  double dead_work(const State& state) const;
  /// f_dead of the stage times some displacements [FL].
  double dead_product(std::span<const double> d) const;

 private:
  /// Share of the largest force level so far.
  static constexpr double force_level_floor = 0.1;

  double passive_energy(const State& state, const LawValues& laws) const;
  std::vector<double> rounding_of_forces(std::span<const double> d, double load_factor) const;
  void make_screen();
  void screen_intact_points();
  std::vector<Mat2> path_tangents(const LawValues& laws) const;
  double block_forces(std::span<const double> d) const;
  std::vector<Vec2> openings(std::span<const double> d, double load_factor) const;
  std::vector<Vec2> openings(const Displacements& d, double load_factor) const;
  LawValues laws_of(std::vector<Vec2> openings) const;

  const Equilibrium& equilibrium_;
  const Loading* loading_;
  bool has_dead_ = false;
  Functional reference_, reference_work_;  ///< f_ref · d, and of the forces that do work
  struct Loaded {
    std::size_t node;  ///< of a block, or of its strain gradient
    Vec6 dead, live;
  };
  std::vector<Loaded> loaded_;
  Functional dead_springs_;  ///< what the far ends of driven springs add to f_dead · d
  LinearSystem linear_;
  std::unique_ptr<LinearSystem> physical_;  ///< only when multipliers are iterated
  DirectSolverChoice solver_;
  std::unique_ptr<LinearSystem> contact_;  ///< only where contacts are solved
  std::vector<Mat2> path_tangent_;         ///< D̄ in use, only then
  std::vector<Vec2> multipliers_;
  std::vector<History> history_;
  /// What the laws of intact points need not be asked for, side by side for one cheap test.
  struct Screen {
    double bound = 0;               ///< squared; 0 when the law must be asked [L²]
    double shear = 0;               ///< β²
    Vec2 stiffness = Vec2::Zero();  ///< D0
  };
  std::vector<Screen> screen_;
  mutable std::int64_t num_screened_ = 0;
  bool frozen_ = false, joins_by_contact_ = false;
  double highest_level_ = 0;
  struct Remembered {
    State at;
    std::shared_ptr<const LawValues> laws;
  };
  Remembered remembered_;
  std::size_t stamps_ = 0, used_stamp_ = 0;
  std::unique_ptr<Timings> own_timings_ = std::make_unique<Timings>();
  Timings* timings_ = own_timings_.get();
};

}  // namespace dda
