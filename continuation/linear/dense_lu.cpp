#include "continuation/linear/dense_lu.hpp"

#include <cmath>
#include <utility>

extern "C" void dgetrf_(const int* rows, const int* columns, double* a, const int* stride, int* exchanges,
                        int* info);

namespace dda {

bool DenseLu::compute(Eigen::MatrixXd a) {
  lu_ = std::move(a);
  const int n = static_cast<int>(lu_.rows());
  exchanges_.resize(static_cast<std::size_t>(n));
  if (n == 0) return true;
  int info = 0;
  dgetrf_(&n, &n, lu_.data(), &n, exchanges_.data(), &info);
  return info == 0 && std::isfinite(lu_.diagonal().sum());
}

Eigen::MatrixXd DenseLu::solve(Eigen::MatrixXd b) const {
  for (std::size_t i = 0; i < exchanges_.size(); ++i)
    if (const int j = exchanges_[i] - 1; j != static_cast<int>(i))
      b.row(static_cast<Eigen::Index>(i)).swap(b.row(j));
  lu_.triangularView<Eigen::UnitLower>().solveInPlace(b);
  lu_.triangularView<Eigen::Upper>().solveInPlace(b);
  return b;
}

}  // namespace dda
