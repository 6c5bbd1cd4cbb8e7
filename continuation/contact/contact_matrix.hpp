#pragma once

#include <vector>

#include "continuation/contact/changing_inverse.hpp"
#include "continuation/contact/contact_problem.hpp"

namespace dda {

/// ∂F/∂x of a contact problem and its inverse, kept from walk to walk for as long as couplings, loads and the
/// control stay:
///
///     ∂F/∂x = [1, −q_ref; g] + C E,     E_p = W (D_p − D_base), 2 × 2 per point
///
/// Few points that change are changes of rank one; for many it is factorised anew.
class ContactMatrix {
 public:
  using Vector = Eigen::VectorXd;

  /// Makes it the one with these E; false when that is singular.
  bool move_to(const ContactProblem& problem, const std::vector<Mat2>& changes);
  /// Factorises it anew.
  bool factor(const ContactProblem& problem, const std::vector<Mat2>& changes);
  /// u vᵀ, which is added to the E of a point and makes it `sum`.
  struct RankOne {
    std::size_t point = 0;
    Vec2 u, v;
    Mat2 sum;
  };
  /// The factor by which the determinant changes.
  double add(const ContactProblem& problem, const RankOne& change);
  /// Whether so many changes have been added, or one that nearly made it singular, that it is better
  /// factorised anew.
  bool is_worn() const;
  std::size_t size() const { return inverse_.size(); }
  Vector solve(const Vector& b) const { return inverse_.solve(b); }
  /// Brings a solution before the last change up to it.
  void update(Vector& x) const { inverse_.update(x); }
  int num_factorisations() const { return num_factorisations_; }
  /// Changes of rank one so far.
  std::size_t num_changes() const { return num_changes_; }
  /// Forgets everything, as where the couplings, the loads or the control are others now.
  void reset() { changes_.clear(); }

 private:
  bool has_factors() const { return !changes_.empty(); }

  ChangingInverse inverse_;
  std::vector<Mat2> changes_;  ///< E; none without factors
  bool is_nearly_singular_ = false;
  int num_factorisations_ = 0;
  std::size_t num_changes_ = 0;
};

}  // namespace dda
