#include "continuation/linear/dense/dense_product.hpp"

extern "C" void dgemm_(const char* of_a, const char* of_b, const int* rows, const int* columns,
                       const int* inner, const double* factor, const double* a, const int* stride_of_a,
                       const double* b, const int* stride_of_b, const double* share_of_c, double* c,
                       const int* stride_of_c);

namespace dda {

Eigen::MatrixXd product_of_transpose(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                     const Eigen::Ref<const Eigen::MatrixXd>& b) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(a.cols(), b.cols());
  if (out.size() == 0 || a.rows() == 0) return out;
  const auto size = [](Eigen::Index i) { return static_cast<int>(i); };
  const int rows = size(a.cols()), columns = size(b.cols()), inner = size(a.rows());
  const int stride_of_a = size(a.outerStride()), stride_of_b = size(b.outerStride());
  const char transposed = 'T', as_it_is = 'N';
  const double one = 1, none = 0;
  dgemm_(&transposed, &as_it_is, &rows, &columns, &inner, &one, a.data(), &stride_of_a, b.data(),
         &stride_of_b, &none, out.data(), &rows);
  return out;
}

}  // namespace dda
