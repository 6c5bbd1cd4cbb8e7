#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "models/interface/law.hpp"

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
    bool is_exact = false;         ///< whether q has an unknown multiplier in it
    bool slides = false;           ///< which side is meant at the limit of friction
    Vec2 traction = Vec2::Zero();  ///< at q = 0, without contact
    Mat2 tangent = Mat2::Zero();   ///< without contact
  };
  std::vector<Point> points;
  Eigen::VectorXd live;       ///< q_ref
  Eigen::VectorXd control;    ///< g
  Eigen::VectorXd constant;   ///< c
  Eigen::MatrixXd couplings;  ///< C, (2 · points + 1) × 2 · points
  double accuracy = 0;        ///< of F that counts as none [L]
};

}  // namespace dda
