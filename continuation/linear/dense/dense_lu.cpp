#include "continuation/linear/dense/dense_lu.hpp"

#include <cmath>
#include <utility>

extern "C" void dgetrf_(const int* rows, const int* columns, double* a, const int* stride, int* exchanges,
                        int* info);
extern "C" void dgetrs_(const char* which, const int* rows, const int* columns, const double* a,
                        const int* stride, const int* exchanges, double* b, const int* stride_of_b,
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
  const int n = static_cast<int>(lu_.rows()), columns = static_cast<int>(b.cols());
  if (n == 0 || columns == 0) return b;
  const char as_it_is = 'N';
  int info = 0;
  dgetrs_(&as_it_is, &n, &columns, lu_.data(), &n, exchanges_.data(), b.data(), &n, &info);
  return b;
}

}  // namespace dda
