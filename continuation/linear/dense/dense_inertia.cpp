#include "continuation/linear/dense/dense_inertia.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

extern "C" void dsytrf_(const char* triangle, const int* n, double* a, const int* stride, int* exchanges,
                        double* work, const int* work_size, int* info);

namespace dda {

std::optional<int> num_positive_eigenvalues(Eigen::MatrixXd a) {
  const int n = static_cast<int>(a.rows());
  if (n == 0) return 0;
  std::vector<int> exchanges(static_cast<std::size_t>(n));
  constexpr int columns_at_once = 64;
  const int room = columns_at_once * n;
  std::vector<double> work(static_cast<std::size_t>(room));
  int info = 0;
  dsytrf_("L", &n, a.data(), &n, exchanges.data(), work.data(), &room, &info);
  if (info != 0 || !std::isfinite(a.diagonal().sum())) return {};
  int positive = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (exchanges[static_cast<std::size_t>(i)] < 0) {  // a 2 × 2 pivot: one eigenvalue of each sign
      ++positive;
      ++i;
    } else if (a(i, i) > 0) {
      ++positive;
    }
  }
  return positive;
}

}  // namespace dda
