#include "continuation/detour/increment/fictitious_mass.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <stdexcept>

namespace dda {
namespace {

using Factor = Eigen::LLT<Mat6>;

std::vector<Factor> diagonal_factors(const BlockMatrix& k) {
  std::vector<Factor> out;
  for (std::size_t row = 0; row < k.num_rows(); ++row)
    for (std::size_t slot = k.row_start()[row]; slot < k.row_start()[row + 1]; ++slot) {
      if (k.columns()[slot] != row) continue;
      out.emplace_back(k.value(slot));
      if (out.back().info() != Eigen::Success)
        throw std::invalid_argument("a diagonal block of the stiffness is not positive definite");
    }
  return out;
}

/// ‖L_i⁻¹ K_ij L_j⁻ᵀ‖, the largest singular value.
double coupling(const Factor& i, const Mat6& kij, const Factor& j) {
  const Mat6 left = i.matrixL().solve(kij);
  const Mat6 both = j.matrixL().solve(left.transpose());
  return Eigen::JacobiSVD<Mat6>(both).singularValues()[0];
}

}  // namespace

FictitiousMass::FictitiousMass(const BlockMatrix& stiffness) {
  constexpr double margin = 1.2;  // γ
  const std::vector<Factor> diagonal = diagonal_factors(stiffness);
  for (std::size_t row = 0; row < stiffness.num_rows(); ++row) {
    double sum = 0;
    for (std::size_t slot = stiffness.row_start()[row]; slot < stiffness.row_start()[row + 1]; ++slot) {
      const std::size_t column = stiffness.columns()[slot];
      sum += column == row ? 1 : coupling(diagonal[row], stiffness.value(slot), diagonal[column]);
    }
    inverses_.emplace_back(4 / (margin * sum) * diagonal[row].solve(Mat6::Identity()));
  }
}

void FictitiousMass::solve(std::span<double> x) const {
  for (std::size_t i = 0; i < inverses_.size(); ++i) {
    Eigen::Map<Vec6> at(x.data() + 6 * i);
    at = (inverses_[i] * at).eval();
  }
}

}  // namespace dda
