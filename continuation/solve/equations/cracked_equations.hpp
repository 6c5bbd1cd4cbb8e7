#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "continuation/contact/contact_walk.hpp"
#include "continuation/equation/control_equation.hpp"
#include "continuation/linear/dense/condensed_update.hpp"
#include "continuation/solve/equations/equations.hpp"
#include "continuation/solve/equations/pieces_watch.hpp"
#include "continuation/solve/equations/whole_equations.hpp"

namespace dda {

/// Whether no damage grows in a point within an equilibrium: it was never bonded, or loses its strength between one and the
/// next. Where that is so of all, the equations are linear from piece to piece of contact and friction.
bool changes_by_contact_alone(const InterfacePoint& point);

/// Equilibrium of the points with columns under one control, everything else being linear.
///
///     F = q − q_dead − (λ − λ₀) q_ref − m + G (z − z₀),     z = W (t(q; h) − D_base (q − m)),     N(q, λ) = 0
///     d = d_dead + (λ − λ₀) d_ref − Z (z − z₀)
///
/// with the base, Z and G of a LinearSystem and the iterated multipliers m; z₀ = 0 and λ₀ = 0 until refined. Multipliers of points
/// that are held as in the base but for them, t = D_base q, are loads of d_dead, and what initial stress opens, q₀(λ), is one
/// of d_dead and d_ref on all of them and counts in q_dead and q_ref. An iteration costs a dense solve of the
/// size of the cracked components.
class CrackedEquations final : public WalkedEquations {
 public:
  /// What the error of q is measured by: the openings, or what the points carry, t/(E/h), by which
  /// equilibrium is judged: joints may open much further than they are pressed together.
  enum class Accuracy { of_openings, of_what_is_carried };
  /// When an iteration ends. Newton's method ends after `most` iterations, and after `max_iterations` that bring no new
  /// set of pieces of the laws; a set that comes back ends it at once where something else can be tried.
  struct Rule {
    int max_iterations = NewtonParameters::usual;
    int most = 50;
    bool may_settle = false;  ///< of Newton's method: sets may come back
    int at_least = 0;         ///< of walks
    Accuracy accuracy = Accuracy::of_openings;
    bool searches = true;                ///< of walks: other ways where the straight one leads nowhere
    std::function<bool()> is_over = {};  ///< gives walks up, see WalkRule

    /// As the parameters have it, which if they limit the iterations limit them all.
    static Rule of(const NewtonParameters& newton) {
      Rule out;
      out.most = newton.max_iterations.value_or(out.most);
      out.max_iterations = newton.most();
      return out;
    }
  };

  CrackedEquations(const System& system, LinearSystem& linear, const ControlSum& control);

  /// The openings of a state, from which an iteration by Newton's method begins with the multipliers of now.
  Iterate begin(const State& guess, const Rule& rule);
  /// The first walk begins at the start of the step, with what cracks made linear at the guess.
  Iterate begin_walks(const State& start, const State& guess, const Rule& rule);
  /// Walks go on from where the last iterate was, which has been made the origin (`refine`): what they correct is near,
  /// and no other way to it is sought than the straight one.
  Iterate go_on_walking(const Rule& rule);
  std::size_t num_points() const { return points_.size(); }
  /// Whether all of them change by contact alone.
  bool only_touch() const { return only_touch_; }
  /// Makes the z and λ found so far the origin z₀, λ₀, d_dead being solved for with them: they may be large, as where
  /// points slide that are held in the base, and then so are the errors of Z and G in their products, and the rounding
  /// of sums in which they cancel: what drives a support would drag along all that hangs on it. The
  /// iteration goes on from there.
  void refine();
  /// The whole structure at an iterate.
  State state(const Iterate& at);
  /// ‖R‖ of that state as far as the equations tell, R = Bᵀ (W (t − D_base B d) − z) [F].
  double residual_norm(const State& at) const;

  Unknowns unknowns() const override { return Unknowns::cracked; }
  std::size_t size() const override { return 2 * points_.size(); }
  void residual(const Iterate& at, std::span<double> out) override;
  double norm(const Iterate& at) override;
  void load_derivative(const Iterate& at, std::span<double> out) override;
  bool factorise(const Iterate& at) override;
  void solve(const Iterate& at, std::span<const std::span<double>> columns) override;
  void multiply(const Iterate& at, std::span<const double> in, std::span<double> out) override;
  double control(const Iterate& at) override;
  double control_gradient(const Iterate& at, std::span<double> per_x) override;
  double per_path() const override { return -1 / control_.scale; }
  Verdict judge(const Iterate& at, int iterations) override;
  /// Contact and friction solved exactly (contact_walk.hpp), what cracks by its tangent.
  std::vector<double> walk_from(const Iterate& at) override;

 private:
  /// By so much the equations may be missed, of the size of the openings or of what the points carry.
  static constexpr double good = 1e-11;

  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  Eigen::Index length() const { return 2 * static_cast<Eigen::Index>(points_.size()); }
  std::shared_ptr<const std::vector<double>> pulled_by_offsets() const;
  std::vector<double> opened_by(const std::vector<double>& offsets) const;
  Iterate start_at(const State& guess, const Rule& rule, bool walks);
  Vector openings(const State& at) const;
  Vec2 multiplier(std::size_t i) const;
  Vec2 offset(std::size_t i, double load_factor) const;
  double opening_scale() const;
  double largest_miss(Accuracy accuracy) const;
  bool is_solved(Accuracy accuracy) const;
  void evaluate(const Iterate& at);
  void evaluate();
  std::size_t pieces() const;
  auto couplings(std::size_t i) const {
    return linear_.couplings().block(0, 2 * static_cast<Eigen::Index>(i), length(), 2);
  }
  Vector gap() const;
  std::vector<double> unbalanced(const State& at) const;
  State state_here();
  std::vector<bool> steady_points() const;
  double value() const;
  double rounding_of_value() const;
  Verdict judge_newton(int iterations);
  Verdict judge_walks(int iterations);
  double error_of_walks() const;
  std::optional<Vector> search(WalkRule rule);
  void linearise();
  void set_coefficients(double unit);
  ContactProblem::Point point_of(std::size_t i) const;

  const System& system_;
  LinearSystem& linear_;
  const ControlSum control_;
  const std::vector<std::size_t> points_;
  Vector dead_, live_;               ///< q_dead + m, q_ref
  std::vector<double> live_change_;  ///< of d_ref by initial stress; empty without
  Vector along_;                     ///< Zᵀ ∂g/∂d
  double gauge_dead_ = 0, gauge_live_ = 0;
  bool only_touch_ = false;
  std::shared_ptr<const std::vector<double>> origin_;  ///< d_dead where it is another one
  Vector z_origin_;                                    ///< z₀
  double load_origin_ = 0;                             ///< λ₀

  // at the last iterate
  Vector q_, z_, difference_, spending_;
  mutable std::optional<Vector> coupled_;  ///< G (z − z₀), once it was asked for
  double load_factor_ = 0, spent_ = 0;
  double carried_ = 0;               ///< largest t/(E/h) of the points [L]
  double scale_ = 0;                 ///< size of the openings of the loads alone and of the guess [L]
  std::vector<Mat2> change_;         ///< E
  std::vector<std::size_t> active_;  ///< places in points_ with z or E
  bool is_factorised_ = false;
  CondensedUpdate update_;     ///< 1 + G E
  bool is_condensed_ = false;  ///< since the iteration began

  // of the iteration
  Rule rule_;
  bool walks_ = false;
  PiecesWatch pieces_;
  std::vector<double> start_;  ///< x where it begins
  Vector walk_start_;          ///< q and λ where the next walk begins
  Vector before_;              ///< q of the iterate judged last
  double error_before_ = 0;
  int rises_ = 0;           ///< walks that have hardly brought the error down
  ContactProblem problem_;  ///< all but contact and friction made linear
  double unit_ = 0;         ///< of the control in it
  ContactMatrix matrix_;
};

}  // namespace dda
