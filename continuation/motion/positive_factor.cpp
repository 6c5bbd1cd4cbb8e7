#include "continuation/motion/positive_factor.hpp"

#include <omp.h>

#include <Eigen/CholmodSupport>

namespace dda {

struct PositiveFactor::Cholmod {
  Eigen::CholmodDecomposition<Matrix> factor;
};

/// CHOLMOD's own threads cost more than they bring, as in CholmodMatrix.
PositiveFactor::PositiveFactor() : cholmod_(std::make_unique<Cholmod>()) {
  omp_set_max_active_levels(0);
  cholmod_common& options = cholmod_->factor.cholmod();
  options.supernodal = CHOLMOD_AUTO;
  options.final_asis = 0;
  options.final_ll = 1;
  options.print = 0;
  options.quick_return_if_not_posdef = true;
}

PositiveFactor::~PositiveFactor() = default;

void PositiveFactor::analyse(const Matrix& lower) { cholmod_->factor.analyzePattern(lower); }

bool PositiveFactor::factorise(const Matrix& lower) {
  cholmod_->factor.factorize(lower);
  return cholmod_->factor.info() == Eigen::Success;
}

Eigen::VectorXd PositiveFactor::solve(const Eigen::VectorXd& right) const {
  return cholmod_->factor.solve(right);
}

Eigen::MatrixXd PositiveFactor::solve_all(const Eigen::MatrixXd& right) const {
  return cholmod_->factor.solve(right);
}

Eigen::Index PositiveFactor::num_rows() const { return cholmod_->factor.rows(); }

}  // namespace dda
