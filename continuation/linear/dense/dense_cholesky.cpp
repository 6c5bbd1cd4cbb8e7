#include "continuation/linear/dense/dense_cholesky.hpp"

#include <algorithm>

extern "C" void dpotrf_(const char* triangle, const int* n, double* a, const int* stride, int* info);
extern "C" void dlauum_(const char* triangle, const int* n, double* a, const int* stride, int* info);
extern "C" void dtrsm_(const char* side, const char* triangle, const char* transposed, const char* diagonal,
                       const int* rows, const int* columns, const double* factor, const double* a,
                       const int* stride, double* b, const int* stride_of_b);
extern "C" void dsyrk_(const char* triangle, const char* transposed, const int* n, const int* k,
                       const double* factor, const double* b, const int* stride, const double* old, double* a,
                       const int* stride_of_a);

namespace dda {

bool factor_cholesky(Eigen::MatrixXd& a) {
  const int n = static_cast<int>(a.rows());
  int info = 0;
  if (n > 0) dpotrf_("L", &n, a.data(), &n, &info);
  return info == 0;
}

/// LAPACK has U Uᵀ: the rows and columns are turned about, there and back.
void square_of_factor(Eigen::MatrixXd& l) {
  const int n = static_cast<int>(l.rows());
  if (n == 0) return;
  std::reverse(l.data(), l.data() + l.size());
  int info = 0;
  dlauum_("U", &n, l.data(), &n, &info);
  std::reverse(l.data(), l.data() + l.size());
}

void divide_by_transpose(const Eigen::MatrixXd& l, Eigen::MatrixXd& b) {
  const int rows = static_cast<int>(b.rows()), columns = static_cast<int>(b.cols());
  const double one = 1;
  if (b.size() > 0) dtrsm_("R", "L", "T", "N", &rows, &columns, &one, l.data(), &columns, b.data(), &rows);
}

void subtract_square(const Eigen::MatrixXd& b, Eigen::MatrixXd& a) {
  const int n = static_cast<int>(b.rows()), k = static_cast<int>(b.cols());
  const double minus = -1, one = 1;
  if (b.size() > 0) dsyrk_("L", "N", &n, &k, &minus, b.data(), &n, &one, a.data(), &n);
}

}  // namespace dda
