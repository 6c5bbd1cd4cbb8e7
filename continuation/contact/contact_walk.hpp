#pragma once

#include <functional>
#include <optional>

#include "continuation/contact/contact_matrix.hpp"
#include "continuation/contact/contact_piece.hpp"

namespace dda {

/// How long a walk may wander: one of little patience is given up soon after it has turned round, since against a firmer
/// residual stiffness the way is mostly found past far fewer corners.
enum class Patience { little, much };

struct WalkRule {
  double share = 1e-7;       ///< ε of the residual stiffness ε P of what is open or slides
  bool is_taken_off = true;  ///< by corrections at the end
  Patience patience = Patience::much;
  std::function<bool()> is_over = {};  ///< asked at every corner; true gives the walk up

  bool gives_up() const { return is_over && is_over(); }
};

/// Solves a contact problem by walking from piece to piece: with x₀ and F(x₀) = r the solutions of F(x) = τ r are followed
/// from τ = 1 to 0, one point crossing one corner at a time (Katzenelson's algorithm; Lemke's pivoting in the
/// variables of the program). The way turns round in τ where the determinant changes sign.
///
/// What is open or slides keeps a residual stiffness ε P, without which a body all of whose points slide
/// leaves the equations singular; it is taken off again by proximal corrections (an iteration with the
/// regularised matrix on the equations as they are). Where these hardly move, another walk from there with a
/// smaller ε finds the point that sticks. Where the way turns round near τ = 0 the equations as they are may
/// have a solution that those with ε have not: a mechanism that moves on while joints stand at their limits.
/// A point at a corner is on the piece on which it has come to stand; where much patience finds nothing from there, on the
/// one on which its opening lies.
/// Ends after finitely many corners, for any coefficient of friction, when it starts from closed and stuck
/// joints pressed together (`covered`): then no ray leads to infinity. Nothing where the equations have no
/// solution, as beyond the load of a mechanism. `matrix` is kept from walk to walk.
std::optional<Eigen::VectorXd> walk_from(const ContactProblem& problem, const Eigen::VectorXd& start,
                                         ContactMatrix& matrix, const WalkRule& rule = {});
/// Solves it by many walks, each centred at the end of the one before (proximal point method), where a single
/// one wanders, as among the many states in which bricks are wedged by strong friction: with more residual
/// stiffness a walk ends soon, and from there with less again. Where less wanders, the same again, twice as
/// often each time or until what moves is nearly at rest, as in viscous motion. Given up where it has moved much
/// farther than the loads open joints: what no residual stiffness keeps near has no solution. And given up after twenty
/// corners a point, more than any search that found something has been seen to pass.
std::optional<Eigen::VectorXd> walk_proximally(const ContactProblem& problem, Eigen::VectorXd start,
                                               ContactMatrix& matrix, const WalkRule& rule = {});
/// Solves it by a walk that starts with all joints closed and held, so far overlapping that no ray leads to
/// infinity.
std::optional<Eigen::VectorXd> walk_covered(const ContactProblem& problem, ContactMatrix& matrix,
                                            const WalkRule& rule = {});

}  // namespace dda
