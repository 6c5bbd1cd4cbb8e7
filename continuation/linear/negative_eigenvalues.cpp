// How many eigenvalues of the tangent are negative.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "continuation/linear/dense/dense_inertia.hpp"
#include "continuation/linear/dense/two_by_two.hpp"
#include "continuation/linear/linear_system.hpp"

namespace dda {
namespace {

using Vector = Eigen::VectorXd;

bool is_symmetric(const Mat2& a) {
  constexpr double round_off = 1e-12;
  return std::abs(a(0, 1) - a(1, 0)) <= round_off * a.cwiseAbs().maxCoeff();
}

std::vector<Mat2> symmetric_parts(const std::vector<Mat2>& of) {
  std::vector<Mat2> out;
  out.reserve(of.size());
  for (const Mat2& a : of) out.push_back(symmetric_part(a));
  return out;
}

/// Block-diagonal times vector.
Vector product(const std::vector<Mat2>& blocks, const Vector& x) {
  Vector out(x.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto at = 2 * static_cast<Eigen::Index>(i);
    out.segment<2>(at) = blocks[i] * x.segment<2>(at);
  }
  return out;
}

std::span<double> span_of(Vector& x) { return {x.data(), static_cast<std::size_t>(x.size())}; }
std::span<const double> span_of(const Vector& x) { return {x.data(), static_cast<std::size_t>(x.size())}; }

}  // namespace

bool LinearSystem::has_symmetric_tangent() const { return std::ranges::all_of(tangent_, is_symmetric); }

NegativeEigenvalues LinearSystem::negative_eigenvalues() {
  NegativeEigenvalues out{{}, num_negative_of_symmetric_part()};
  if (!out.of_symmetric_part) return out;
  if (has_symmetric_tangent())
    out.of_stiffness = out.of_symmetric_part;
  else if (equilibrium_.num_unknown_multipliers() == 0)
    out.of_stiffness = num_negative_eigenvalues(
        general_ || solver_.num_negative_pivots() > 0 ? whole_stiffness() : stiffness_of_points(),
        *out.of_symmetric_part);
  return out;
}

std::optional<int> LinearSystem::num_negative_of_symmetric_part() {
  if (general_ && !solver_.factor(matrix_with(symmetric_parts(base_)))) return {};
  int out = solver_.num_negative_pivots();
  if (out < 0) return {};
  std::vector<double> e;
  std::vector<std::pair<std::size_t, Vec2>> v;  // point and direction of each
  for (const std::size_t p : active_) {
    const Mat2 change = symmetric_part(update_of(p));
    constexpr double round_off = 1e-12;
    const double size = change.cwiseAbs().maxCoeff();
    const Eigen::SelfAdjointEigenSolver<Mat2> own(change);
    for (Eigen::Index k = 0; k < 2; ++k) {
      if (std::abs(own.eigenvalues()[k]) <= round_off * size) continue;
      e.push_back(own.eigenvalues()[k]);
      v.emplace_back(p, own.eigenvectors().col(k));
      if (e.back() > 0) --out;
    }
  }
  const auto r = static_cast<Eigen::Index>(e.size());
  Eigen::MatrixXd small(r, r);
  for (std::size_t a = 0; a < e.size(); ++a)
    for (std::size_t b = 0; b < e.size(); ++b)
      small(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) =
          v[a].second.dot(coupling(v[a].first, v[b].first) * v[b].second) + (a == b ? 1 / e[a] : 0);
  const auto positive = num_positive_eigenvalues(std::move(small));
  if (!positive) return {};
  return out + *positive;
}

/// By all unknowns: where the unsymmetric tangent is the base, whose symmetric part the solver has
/// factorised, and beside an indefinite base, whose softening the updated points need not see.
UnsymmetricStiffness LinearSystem::whole_stiffness() {
  const auto symmetric = std::make_shared<const std::vector<Mat2>>(symmetric_parts(tangent_));
  std::vector<Mat2> updates;
  for (const std::size_t p : active_) updates.push_back(symmetric_part(update_of(p)));
  auto small = std::make_shared<DenseLu>();
  small->compute(one_plus_couplings(updates));
  return {.size = static_cast<Eigen::Index>(n()),
          .metric =
              [this](const Vector& x) {
                Vector out = Vector::Zero(x.size());
                equilibrium_.intact().multiply_add(span_of(x), span_of(out));
                return out;
              },
          .flexibility =
              [this, updates, small](Vector b) {
                const std::span<double> x = span_of(b);
                solver_.solve(x, 1);
                Vector opening(2 * static_cast<Eigen::Index>(active_.size()));
                for (std::size_t a = 0; a < active_.size(); ++a)
                  opening.segment<2>(2 * static_cast<Eigen::Index>(a)) = rows_times(active_[a], x);
                subtract_columns(active_, small->solve(product(updates, opening)), {&x, 1});
                return b;
              },
          .whole_flexibility =
              [this](const Vector& b) {
                Vector x(b.size());
                solve(span_of(b), span_of(x));
                return x;
              },
          .skew_forces =
              [this, symmetric](const Vector& x) {
                Vector whole(x.size()), straight(x.size());
                multiply(tangent_, span_of(x), span_of(whole));
                multiply(*symmetric, span_of(x), span_of(straight));
                return Vector(whole - straight);
              }};
}

/// By the updated points alone: U K⁻¹ Uᵀ = G (1 + E G)⁻¹.
UnsymmetricStiffness LinearSystem::stiffness_of_points() {
  std::vector<Mat2> updates, skew;
  for (const std::size_t p : active_) {
    updates.push_back(symmetric_part(update_of(p)));
    skew.push_back(update_of(p) - updates.back());
  }
  auto small = std::make_shared<DenseLu>();
  small->compute(one_plus_couplings(updates));
  const auto r = static_cast<Eigen::Index>(2 * active_.size());
  auto couplings = std::make_shared<Eigen::MatrixXd>(r, r);
  for (std::size_t a = 0; a < active_.size(); ++a)
    for (std::size_t b = 0; b < active_.size(); ++b)
      couplings->block<2, 2>(2 * static_cast<Eigen::Index>(a), 2 * static_cast<Eigen::Index>(b)) =
          coupling(active_[a], active_[b]);
  return {.size = r,
          .metric = [](const Vector& x) { return x; },
          .flexibility = [=](const Vector& b) { return Vector(*couplings * small->solve(b)); },
          .whole_flexibility = [couplings,
                                this](const Vector& b) { return Vector(*couplings * small_.solve(b)); },
          .skew_forces = [skew](const Vector& x) { return product(skew, x); }};
}

}  // namespace dda
