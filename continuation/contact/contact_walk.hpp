#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "continuation/contact/contact_piece.hpp"

namespace dda {

/// Equilibrium of some points under one control, linear but for contact and friction:
///
///     F(x) = (q − λ q_ref, g · x) + c + C z,    x = (q, λ),    z_p = W (t_p(q_p) − D_base (q_p − m_p))
///
/// size 2 · points + 1. A point with a `contact` has its pieces, any other the linear traction given.
struct ContactProblem {
  struct Point {
    double weight = 0;
    Vec2 trial = Vec2::Zero();       ///< diag P
    Mat2 base = Mat2::Zero();        ///< D_base
    Vec2 multiplier = Vec2::Zero();  ///< m
    std::optional<Contact> contact;
    bool slides = false;           ///< which side is meant at the limit of friction
    Vec2 traction = Vec2::Zero();  ///< at q = 0, without contact
    Mat2 tangent = Mat2::Zero();   ///< without contact
  };
  std::vector<Point> points;
  Eigen::VectorXd live;          ///< q_ref
  Eigen::VectorXd control;       ///< g
  Eigen::VectorXd constant;      ///< c
  Eigen::MatrixXd couplings;     ///< C, (2 · points + 1) × 2 · points
  double accuracy = 0;           ///< of F that counts as none [L]
  double residual_share = 1e-7;  ///< ε
  bool corrects = true;          ///< whether it is taken off again
};

/// Solves it by walking from piece to piece: with x₀ and F(x₀) = r the solutions of F(x) = τ r are followed
/// from τ = 1 to 0, one point crossing one corner at a time (Katzenelson's algorithm; Lemke's pivoting in the
/// variables of the program). The way turns round in τ where the determinant changes sign.
///
/// What is open or slides keeps a residual stiffness ε P, without which a body all of whose points slide
/// leaves the equations singular; it is taken off again by proximal corrections (an iteration with the
/// regularised matrix on the equations as they are). Where these hardly move, another walk from there with a
/// smaller ε finds the point that sticks. Ends after finitely many corners, for any coefficient of friction,
/// when it starts from closed and stuck joints pressed together (`covered`): then no ray leads to infinity.
/// Nothing where the equations have no solution, as beyond the load of a mechanism.
std::optional<Eigen::VectorXd> walk_from(const ContactProblem& problem, const Eigen::VectorXd& start);
/// Where such a walk wanders, as among the many states in which bricks are wedged by strong friction: with
/// more residual stiffness it ends soon, and from there with less again, the end of each walk being the
/// centre of the next (proximal point method). Where less wanders, the same again, twice as often each time or
/// until what moves is nearly at rest, as in viscous motion.
std::optional<Eigen::VectorXd> walk_proximally(ContactProblem problem, Eigen::VectorXd start);
std::optional<Eigen::VectorXd> walk_covered(const ContactProblem& problem);

}  // namespace dda
