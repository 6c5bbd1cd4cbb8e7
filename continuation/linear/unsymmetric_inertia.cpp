#include "continuation/linear/unsymmetric_inertia.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Without a preferred direction, and the same for every run.
Vector scattered(Eigen::Index size) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  Vector out(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double turn = golden * static_cast<double>(i + 1);
    out[i] = turn - std::floor(turn) - 0.5;
  }
  return out;
}

Matrix symmetric_part(const Matrix& a) { return 0.5 * (a + a.transpose()); }

/// Lanczos' method for M H⁻¹ M x = ν M x, whose ν < 0 are as many as H has negative eigenvalues and stand
/// apart from the others at their lower end.
class Lanczos {
 public:
  explicit Lanczos(const UnsymmetricStiffness& k) : k_(k) {}

  /// Enlarges the space; false when it is invariant.
  bool grow() {
    Vector x = motions_.cols() == 0 ? Vector(k_.flexibility(k_.metric(scattered(k_.size)))) : next_;
    const double before = x.norm();
    for (int pass = 0; pass < 2; ++pass) x -= motions_ * (forces_.transpose() * x);
    constexpr double round_off = 1e-10;
    if (!(x.norm() > round_off * before)) return false;
    Vector b = k_.metric(x);
    const double length = std::sqrt(x.dot(b));
    append(x / length, motions_);
    append(b / length, forces_);
    next_ = k_.flexibility(forces_.rightCols(1));
    append(next_, answers_);
    return true;
  }

  /// Combinations of the forces, orthonormal, under which H softens; the softest first.
  Matrix softening() const {
    const Eigen::SelfAdjointEigenSolver<Matrix> ritz(symmetric_part(forces_.transpose() * answers_));
    return forces_ * ritz.eigenvectors().leftCols((ritz.eigenvalues().array() < 0).count());
  }

 private:
  static void append(const Vector& column, Matrix& to) {
    to.conservativeResize(column.size(), to.cols() + 1);
    to.rightCols(1) = column;
  }

  const UnsymmetricStiffness& k_;
  Matrix motions_ = Matrix(k_.size, 0), forces_ = Matrix(k_.size, 0), answers_ = Matrix(k_.size, 0);
  Vector next_;
};

/// b, as near to the eigenvectors as a few more steps bring them.
std::optional<Matrix> softening_forces(const UnsymmetricStiffness& k, int count) {
  constexpr int most = 60, more = 4;
  Lanczos lanczos(k);
  Matrix out(k.size, 0);
  for (int step = 0, found_at = most; step < most && step <= found_at + more && lanczos.grow(); ++step) {
    out = lanczos.softening();
    if (out.cols() >= count) found_at = std::min(found_at, step);
  }
  if (out.cols() != count) return {};
  return out;
}

Matrix columns(const UnsymmetricStiffness::Operator& of, const Matrix& x) {
  Matrix out(x.rows(), x.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i) out.col(i) = of(x.col(i));
  return out;
}

int num_negative(const Matrix& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Matrix> all(symmetric, Eigen::EigenvaluesOnly);
  return static_cast<int>((all.eigenvalues().array() < 0).count());
}

/// Whether hardly more than weak springs holds the structure: the sign of what is left is rounding.
bool is_loose(const UnsymmetricStiffness& k, const Matrix& b, const Matrix& c) {
  constexpr double far = 1e8;
  const Matrix of_symmetric_part = b.transpose() * columns(k.flexibility, b);
  return !(c.cwiseAbs().maxCoeff() < far * of_symmetric_part.cwiseAbs().maxCoeff());
}

/// Whether S is too weak to turn any of the softening motions.
bool is_hardly_skew(const UnsymmetricStiffness& k, const Matrix& b) {
  const Matrix x = columns(k.flexibility, b);
  const Matrix soft = symmetric_part(-b.transpose() * x);
  const Matrix turned = columns(k.skew_forces, x), between = x.transpose() * turned;
  const Matrix outside = turned.transpose() * columns(k.flexibility, turned);
  const Matrix inside = between.transpose() * soft.llt().solve(between);
  return symmetric_part(soft - outside - inside).llt().info() == Eigen::Success;
}

}  // namespace

std::optional<int> num_negative_eigenvalues(const UnsymmetricStiffness& k, int of_symmetric_part) {
  if (of_symmetric_part == 0) return 0;
  const auto b = softening_forces(k, of_symmetric_part);
  if (!b) return {};
  const Matrix c = b->transpose() * columns(k.whole_flexibility, *b);
  if (is_loose(k, *b, c)) return {};
  const int q = num_negative(symmetric_part(c));
  if (q == 0) return 0;
  if (q == 1 && c.determinant() < 0) return 1;
  if (q == of_symmetric_part && is_hardly_skew(k, *b)) return q;
  return {};
}

}  // namespace dda
