#pragma once

#include <optional>
#include <set>
#include <vector>

#include "continuation/contact/contact_walk.hpp"
#include "continuation/equation/control_equation.hpp"

namespace dda {

/// The equations of the points with columns under one control, everything else being linear.
///
///     q = q_dead + λ q_ref + m − G (z − z₀),     z = W (t(q; h) − D_base (q − m)),     N(q, λ) = 0
///     d = d_dead + λ d_ref − Z (z − z₀)
///
/// with the base, Z and G of a LinearSystem and the iterated multipliers m; z₀ = 0 until refined. An
/// iteration costs a dense solve of the size of the cracked components.
class CrackedPoints {
 public:
  CrackedPoints(const System& system, LinearSystem& linear, const ControlSum& control);

  /// Begins at a state's openings, with the multipliers of now.
  void start_at(const State& guess);
  std::size_t num_points() const { return points_.size(); }
  /// Whether all of them are contacts, without damage.
  bool only_touch() const { return only_touch_; }
  /// Newton's method; the number of iterations, or nothing. Those that bring a new set of pieces do not count
  /// against `max_iterations`; a set that comes back ends it at once where something else can be tried.
  enum class Cycles { end_it, may_settle };
  std::optional<int> newton(int max_iterations, Cycles cycles);
  /// How well q is wanted: against the openings, or against what the points carry, t/(E/h), by which
  /// equilibrium is judged: joints may open much further than they are pressed together.
  enum class Accuracy { of_openings, of_what_is_carried };
  /// Solves contact and friction exactly (contact_walk.hpp), anew for each tangent of what cracks; the number
  /// of tangents, or nothing.
  std::optional<int> walk(int max_iterations, int at_least = 0, Accuracy accuracy = Accuracy::of_openings);
  /// Makes the z found so far the origin z₀, d_dead being solved for with it: z itself may be large, as where
  /// points slide that are held in the base, and then so are the errors of Z and G in its products. The
  /// iteration goes on from there.
  void refine();
  /// The whole structure where the iteration stands.
  State state() const;

 private:
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  Eigen::Index size() const { return 2 * static_cast<Eigen::Index>(points_.size()); }
  Vec2 multiplier(std::size_t i) const;
  /// What openings are compared with: those that the loads alone make, or what has opened up to a hundred
  /// times as much. What floats away on a singular matrix must not be the measure of its own error.
  double opening_scale() const;
  /// By how much q may miss its equation [L].
  double largest_miss(Accuracy accuracy) const;
  bool is_solved(Accuracy accuracy = Accuracy::of_openings) const;
  void evaluate();
  std::size_t pieces() const;
  auto couplings(std::size_t i) const {
    return linear_.couplings().block(0, 2 * static_cast<Eigen::Index>(i), size(), 2);
  }
  Vector gap() const;
  std::vector<double> unbalanced(const State& at) const;
  double correct();
  void solve_in_place(const Matrix& columns, Matrix& x) const;
  double value() const;
  double rounding_of_value() const;
  double slope(const Vector& dq) const;
  void linearise();
  void set_coefficients(double unit);
  ContactProblem::Point point_of(std::size_t i) const;

  const System& system_;
  LinearSystem& linear_;
  const ControlSum control_;
  const std::vector<std::size_t> points_;
  Vector dead_, live_;  ///< q_dead + m, q_ref
  Vector along_;        ///< Zᵀ ∂g/∂d
  double gauge_dead_ = 0, gauge_live_ = 0;
  bool only_touch_ = false;
  std::vector<double> origin_;  ///< d_dead
  Vector z_origin_;             ///< z₀
  Vector q_, z_, difference_, spending_;
  double load_factor_ = 0, spent_ = 0;
  double carried_ = 0;               ///< largest t/(E/h) of the points [L]
  double scale_ = 0;                 ///< size of the openings of the loads alone and of the guess [L]
  std::vector<Mat2> change_;         ///< E
  std::vector<std::size_t> active_;  ///< places in points_ with z or E
  ContactProblem problem_;           ///< all but contact and friction made linear
  double unit_ = 0;                  ///< of the control in it
  ContactMatrix matrix_;
};

}  // namespace dda
