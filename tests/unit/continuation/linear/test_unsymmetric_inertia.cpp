#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "continuation/linear/unsymmetric_inertia.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Matrix random_matrix(Random& random, Eigen::Index n) {
  Matrix out(n, n);
  for (double& value : out.reshaped()) value = random.between(-1, 1);
  return out;
}

/// H with so many negative eigenvalues, and S of a given size beside it.
struct Sample {
  Matrix h, s;

  Sample(Random& random, Eigen::Index n, Eigen::Index negative, double skew) {
    const Matrix axes = Eigen::HouseholderQR<Matrix>(random_matrix(random, n)).householderQ();
    Vector values(n);
    for (Eigen::Index i = 0; i < n; ++i) values[i] = (i < negative ? -1 : 1) * random.between(0.1, 2);
    h = axes * values.asDiagonal() * axes.transpose();
    const Matrix a = random_matrix(random, n);
    s = skew * (a - a.transpose());
  }

  std::optional<int> count() const {
    const Eigen::Index n = h.rows();
    const Matrix k = h + s;
    return num_negative_eigenvalues(
        {.size = n,
         .metric = [](const Vector& x) { return x; },
         .flexibility = [&](const Vector& b) { return Vector(h.partialPivLu().solve(b)); },
         .whole_flexibility = [&, k](const Vector& b) { return Vector(k.partialPivLu().solve(b)); },
         .skew_forces = [&](const Vector& x) { return Vector(s * x); }},
        num_negative_of_h());
  }
  int num_negative_of_h() const {
    const Eigen::SelfAdjointEigenSolver<Matrix> own(h, Eigen::EigenvaluesOnly);
    return static_cast<int>((own.eigenvalues().array() < 0).count());
  }
  /// Eigenvalues of K φ = μ |H| φ.
  Eigen::VectorXcd eigenvalues() const {
    const Eigen::SelfAdjointEigenSolver<Matrix> own(h);
    const Matrix metric =
        own.eigenvectors() * own.eigenvalues().cwiseAbs().asDiagonal() * own.eigenvectors().transpose();
    return (metric.inverse() * (h + s)).eigenvalues();
  }
};

TEST(UnsymmetricInertia, CountsTheRealNegativeEigenvalues) {
  Random random(1);
  int known = 0, of = 0, strong = 0;
  for (int sample = 0; sample < 4000; ++sample) {
    const auto n = static_cast<Eigen::Index>(random.between(2, 9));
    const auto negative = static_cast<Eigen::Index>(random.between(0, 4));
    const Sample k(random, n, std::min(n, negative), random.between(0, 1.5));
    const auto found = k.count();
    ++of;
    if (!found) continue;
    ++known;
    int real = 0, half = 0;
    for (const auto& mu : k.eigenvalues()) {
      half += mu.real() < 0;
      real += mu.real() < 0 && std::abs(mu.imag()) < 1e-9;
    }
    EXPECT_EQ(*found, *found > 1 ? half : real) << "sample " << sample;
    EXPECT_EQ(*found % 2 == 1, (k.h + k.s).determinant() < 0) << "sample " << sample;
    strong += *found < k.num_negative_of_h();
  }
  EXPECT_GT(known, 3 * of / 4);
  EXPECT_GT(strong, of / 20) << "unsymmetric parts that stabilise must be among the samples";
}

TEST(UnsymmetricInertia, OneSofteningMotionIsAlwaysDecided) {
  Random random(2);
  for (int sample = 0; sample < 500; ++sample) {
    const Sample k(random, 12, 1, random.between(0, 4));
    EXPECT_EQ(k.count(), (k.h + k.s).determinant() < 0 ? 1 : 0) << "sample " << sample;
  }
}

TEST(UnsymmetricInertia, WeakFrictionLeavesTheCountOfTheSymmetricPart) {
  Random random(3);
  for (int sample = 0; sample < 200; ++sample) {
    const Sample k(random, 40, sample % 5, 1e-3);
    EXPECT_EQ(k.count(), sample % 5) << "sample " << sample;
  }
}

}  // namespace
}  // namespace dda
