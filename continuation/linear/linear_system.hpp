#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "continuation/linear/dense/dense_lu.hpp"
#include "continuation/linear/direct/bordered_solver.hpp"
#include "continuation/linear/direct/mumps_matrix.hpp"
#include "continuation/linear/displacements.hpp"
#include "continuation/linear/unsymmetric_inertia.hpp"
#include "continuation/linear/update_columns.hpp"
#include "framework/messages/timings.hpp"
#include "models/crack/growth.hpp"
#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// How many eigenvalues of a stiffness are negative, and of its symmetric part, which is the same for a
/// symmetric one: motions that diverge under dead load, and motions of negative second-order work.
struct NegativeEigenvalues {
  std::optional<int> of_stiffness, of_symmetric_part;
};

/// The tangent of an equilibrium, factorised once and updated where points crack.
///
///     K = K_base + Uᵀ E U,     U = rows B of the changed points,  E = W (D − D_base), 2 × 2 per point
///     K⁻¹ b = y − Z (1 + E G)⁻¹ E U y,   y = K_base⁻¹ b,  Z = K_base⁻¹ Uᵀ,  G = U Z
///
/// Sherman-Morrison-Woodbury. Z and G grow by the columns of points that change for the first time. When so
/// many points have changed that the dense part costs more than a factorisation, the present tangent becomes
/// the base, but for points that soften, unless these alone are too many; that is decided by counts, never by
/// clocks, so that runs repeat. The base is symmetric: of a frictional tangent it takes the symmetric part, and
/// the rest stays an update. Where more slides than is worth updating, and wherever nothing is updated, the
/// unsymmetric tangent is the base itself, by LU, and every other tangent a new one. What hardly more than weak
/// springs hold is no base: where a part of the structure has come loose, if only in an iterate that leads nowhere, joints of
/// which nothing is left are intact in it, and updates.
///
/// Jumps of cuts that come later are a border of the base (bordered_solver.hpp), by which Z and G are corrected.
class LinearSystem {
 public:
  enum class Update { low_rank, refactorise };

  /// A Newton iterate: displacements, load factor and the tractions of the active points.
  struct Iterate {
    std::span<const double> d;
    double load_factor;
    std::span<const Vec2> traction;
  };

  /// d = s d₀ + λ K_base⁻¹ f_ref − Z z.
  struct Combination {
    std::shared_ptr<const std::vector<double>> origin = nullptr;  ///< d₀; none: K_base⁻¹ f_dead
    double share = 1;                                             ///< s
    double load_factor = 0;
    Eigen::VectorXd z = {};  ///< 2 per updated point, the first of them
  };

  /// Factorises; the solver may have analysed the intact stiffness before. Throws InputError where that is
  /// singular.
  LinearSystem(const Equilibrium& equilibrium, std::unique_ptr<DirectSolver> solver, Update update);
  LinearSystem(const Equilibrium& equilibrium, const DirectSolverChoice& solver, Update update)
      : LinearSystem(equilibrium, solver.make(), update) {}
  LinearSystem(const LinearSystem&) = delete;
  LinearSystem& operator=(const LinearSystem&) = delete;
  ~LinearSystem();
  /// Goes on with the unknowns and points that its equilibrium has been given; before that `let_go`. The base and
  /// the columns of points that are still there stay where that can be; else all begins anew.
  void follow(const Growth& growth);
  /// Makes displacements that are sums of its solutions what they are without these.
  void let_go() { settle_pending(); }
  /// Times its phases there from now on.
  void measure_with(Timings& timings) { timings_ = &timings; }

  /// Makes K the tangent with these D, 2 × 2 per active point. False when K is numerically singular.
  bool set_tangent(std::span<const Mat2> tangents);
  /// x = K⁻¹ b, both of size n.
  void solve(std::span<const double> b, std::span<double> x);
  /// K⁻¹ f_ref of the stage.
  Displacements reference_direction();
  /// y = K_base⁻¹ b.
  void solve_base(std::span<const double> b, std::span<double> y);
  /// Turns solutions with K_base into solutions with K, all at once.
  void correct(std::span<const std::span<double>> solutions);
  /// K_base⁻¹ R without a solve, from what is known of the iterate: with z = W (t − D_base B d)
  ///
  ///     K_base⁻¹ R = d − λ K_base⁻¹ f_ref − K_base⁻¹ f_dead + Z z
  ///
  /// False where that is no cheaper than a solve, or columns would have to be made for it.
  bool solve_base_residual(const Iterate& at, std::span<double> y);
  /// A force at a point, and the component of its opening that is asked for.
  struct Hinge {
    std::size_t point;
    Vec2 component, force;
  };
  /// cᵢ · (U K⁻¹ Uᵀ)ᵢⱼ fⱼ of hinges, from couplings alone; nothing where nothing is updated or columns for all
  /// of them are too many.
  std::optional<Eigen::MatrixXd> flexibility(std::span<const Hinge> hinges);
  /// The stiffness with these D, 2 × 2 per active point, whatever the present tangent is.
  BlockMatrix matrix_with(std::span<const Mat2> tangents) const;
  /// y = K x.
  void multiply(std::span<const double> x, std::span<double> y) const;
  /// Whether K is symmetric.
  bool has_symmetric_tangent() const;
  /// Negative eigenvalues of K's symmetric part and, where it tells, of K (unsymmetric_inertia.hpp); nothing
  /// where the solver does not count its pivots. An unsymmetric base is factorised a second time, by its
  /// symmetric part. Of an unsymmetric saddle point the symmetric part alone is known.
  NegativeEigenvalues negative_eigenvalues();

  /// K_base⁻¹ of the loads of a stage (and of their negatives) is computed once per base.
  void begin_stage(const Loading& stage);

  /// Whether cracked points are updates of the base.
  bool updates() const { return update_ == Update::low_rank && !general_; }
  /// Whether a point answers at q as its part of the base does.
  bool is_as_in_base(std::size_t point, const Vec2& q, const Response& now) const;
  bool has_columns(std::size_t point) const { return slot_[point] >= 0; }
  /// Columns for these points; false where a new base would be cheaper.
  bool make_columns(std::span<const std::size_t> points);
  /// Makes K_base the stiffness with these D, 2 × 2 per active point, and forgets all columns; false when it
  /// is singular.
  bool start_from(std::span<const Mat2> base);
  /// Columns for these points, whatever they cost.
  void add_points(std::span<const std::size_t> points) { add_columns(points); }
  /// x −= Z s for each x, s in the columns of `shares`, 2 rows per point.
  void subtract_columns(std::span<const std::size_t> points, const Eigen::MatrixXd& shares,
                        std::span<const std::span<double>> solutions);
  /// As a sum where the active points are so few that all get their columns together: these tell all that a step
  /// asks for. Else, and at the latest when K_base changes, at all nodes.
  Displacements combined(Combination of);
  /// What displacements are a sum of; nothing where they are known at all nodes and no more.
  static std::optional<Combination> combination_of(const Displacements& d);
  /// Zᵀ ∂g/∂d of a gauge, 2 per updated point.
  const Eigen::VectorXd& along_columns(const Functional& gauge);
  /// G, in the order of updated_points(); rows and columns beyond them are spare.
  const Eigen::MatrixXd& couplings() const { return g_; }
  /// G z, z of the first updated points.
  Eigen::VectorXd coupled(const Eigen::VectorXd& z) const;
  /// K_base⁻¹ of the loads that are kept.
  const std::vector<double>& reference_solution() { return solution_of(reference_); }
  const std::vector<double>& dead_solution() { return solution_of(dead_); }

  /// What a restart must bring back: stiffness of the base, and the points whose columns are kept, in their
  /// order.
  const std::vector<Mat2>& base() const { return base_; }
  const std::vector<std::size_t>& updated_points() const { return updated_; }
  /// Numbers of cuts that there were: in the base, and each time when its border has grown.
  std::vector<std::size_t> grown() const;
  bool restore(std::span<const Mat2> base);
  void restore_columns(std::span<const std::size_t> updated);

  std::size_t num_factorisations() const { return num_factorisations_; }
  std::size_t num_solves() const { return num_solves_ + (columns_ ? columns_->num_solves() : 0); }

 private:
  class Combined;
  /// A load of the stage. What follows from it is empty until it is asked for.
  struct Kept {
    std::vector<double> right, solution = {};
    std::vector<Vec2> openings = {};       ///< of the solution, at every active point
    std::optional<double> dead_work = {};  ///< f_dead times the solution
  };

  void begin_anew();
  /// False where the base cannot stay.
  bool grow(const Growth& growth);
  void number_anew(const Growth& growth, std::size_t nodes);
  std::size_t num_border_columns() const;
  /// Whether the active points are so few that all get their columns together.
  bool are_few() const;
  /// How many points get their columns together.
  std::size_t batch() const;
  void make_columns_from(std::size_t first);
  std::vector<double> combined_everywhere(const Combination& of);
  const std::vector<Vec2>& openings_of(Kept& kept);
  double dead_work_of(Kept& kept);
  /// Whether every active point has columns, and is to keep them.
  bool has_all_columns() const { return takes_all_ && updated_.size() == slot_.size(); }
  /// Makes what hangs on Z independent of it.
  void settle_pending();
  /// Makes K_base the stiffness with these D. False when singular; then the base stays what it was.
  bool rebase(std::span<const Mat2> tangents);
  double reference_size();
  bool is_loose(double size_before);
  bool has_loose_parts();
  std::vector<Mat2> held(std::span<const Mat2> base) const;
  bool needs_new_base(std::span<const Mat2> tangents) const;
  bool takes_friction(std::size_t columns) const;
  /// Columns of the batches with a point that needs one.
  std::size_t num_columns(std::span<const Mat2> tangents,
                          const std::function<bool(const Mat2&, std::size_t)>& needs) const;
  void solve_with_base(std::span<double> x);
  /// The same for a load, whose solution is asked for again as cracks grow.
  void solve_load_with_base(std::span<double> x);
  /// Factorises K_base and forgets all columns.
  bool factor_base();
  /// Columns beyond which a new base is cheaper, if it needs half of them at most.
  std::size_t most_columns() const;
  /// Columns beyond which it is made in any case.
  std::size_t most_held_columns() const { return (updates_softening_ ? 2 : 1) * most_columns(); }
  /// Columns for a tangent beside some base.
  std::size_t num_columns_beside(std::span<const Mat2> base, std::span<const Mat2> tangents) const;
  /// What a new base best holds: a tangent, but where it softens what the base held there before. Cracks grow and
  /// rest in turn, and a base that softens would have to be left each time; it has no halves either.
  std::vector<Mat2> stiff_base(std::span<const Mat2> tangents) const;
  std::size_t n() const { return equilibrium_.num_unknowns(); }
  void add_columns(std::span<const std::size_t> points);
  /// y = K x for the K with these D.
  void multiply(std::span<const Mat2> tangents, std::span<const double> x, std::span<double> y) const;
  bool factor_small();
  /// E of a point.
  Mat2 update_of(std::size_t point) const {
    return equilibrium_.point(point).weight * (tangent_[point] - base_[point]);
  }
  Mat2 coupling(std::size_t a, std::size_t b) const { return g_.block<2, 2>(2 * slot_[a], 2 * slot_[b]); }
  /// 1 + E G of the active points for these E.
  Eigen::MatrixXd one_plus_couplings(const std::vector<Mat2>& e) const;
  /// Of the symmetric part, with E = V e Vᵀ and e ≠ 0 the update of it:
  ///
  ///     n₋(K) = n₋(K_base) + n₊(e⁻¹ + Vᵀ G V) − n₊(e)
  ///
  /// (Haynsworth's additivity of inertia for [K_base, (VᵀU)ᵀ; VᵀU, −e⁻¹], whose two Schur complements are K
  /// and −e⁻¹ − Vᵀ G V.) An unsymmetric base is factorised by its symmetric part.
  std::optional<int> num_negative_of_symmetric_part();
  UnsymmetricStiffness whole_stiffness();
  UnsymmetricStiffness stiffness_of_points();
  /// s of K⁻¹ b = y − Z s for these y, two rows per active point.
  Eigen::MatrixXd shares_of(std::span<const std::span<double>> solutions) const;
  std::vector<std::size_t> places_of(std::span<const std::size_t> points) const;
  const std::vector<double>& solution_of(Kept& kept);
  Vec2 rows_times(std::size_t point, std::span<const double> x) const {
    return equilibrium_.opening(point, x);
  }

  const Equilibrium& equilibrium_;
  BorderedSolver solver_;
  std::optional<MumpsMatrix> general_;  ///< the base where it is not symmetric
  Update update_;
  bool updates_softening_ = false;  ///< beside a base that is stiff, and has halves
  std::vector<Mat2> base_, tangent_;
  std::size_t batch_ = 1;                   ///< points that get their columns together
  std::vector<std::size_t> updated_;        ///< points with columns, in order
  std::vector<int> slot_;                   ///< point → index in updated_, −1 when none
  bool takes_all_ = false;                  ///< the active points get their columns together: they are few
  std::unique_ptr<UpdateColumns> columns_;  ///< Z; none beside an unsymmetric base
  Eigen::MatrixXd g_;                       ///< U K_base⁻¹ Uᵀ, at least 2 · updated square
  std::vector<std::size_t> active_;         ///< updated points with E ≠ 0 now
  DenseLu small_;                           ///< of 1 + E G
  Kept reference_, dead_;
  struct KeptGauge {
    std::vector<std::pair<BlockId, Vec6>> rows;
    Eigen::VectorXd along;
  };
  std::vector<KeptGauge> gauges_;
  std::vector<Displacements::Pending> pending_;
  /// What there was when the base was factorised, and each time when its border had grown.
  struct Grown {
    std::size_t cuts, nodes;
  };
  std::vector<Grown> grown_;
  std::size_t num_factorisations_ = 0, num_solves_ = 0;
  Timings own_timings_;
  Timings* timings_ = &own_timings_;
};

}  // namespace dda
