#include "continuation/contact/rate_walk.hpp"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

/// A positive number that belongs to an index: in (1, 1.3) at first, so that no two hinges start at once, and
/// of any size in further trials.
double shortfall(Index index, int trial) {
  const double golden = 0.6180339887498949 * static_cast<double>((index + 1) * (2 * trial + 1));
  const double fraction = golden - std::floor(golden);
  return trial == 0 ? 1 + 0.3 * fraction : std::pow(100, fraction);
}

/// The tableau of
///
///     r = (1 + M) s − λ b + p,     s = ⟨ψ⟩ ≥ 0,   r = ⟨−ψ⟩ ≥ 0,   s_i r_i = 0
///
/// with basic variables in terms of the others. Of each pair (s_i, r_i) one is basic; where λ is, of one pair
/// neither, and one of these two drives.
class Tableau {
 public:
  Tableau(const HingedRates& rates, double direction, int trial)
      : n_(rates.per_load.size()), basic_(n_), other_(n_ + 1) {
    table_.resize(n_, n_ + 1);
    table_.leftCols(n_) = Matrix::Identity(n_, n_) + rates.couplings;
    table_.col(n_) = -direction * rates.per_load;
    rest_.resize(n_);
    for (Index i = 0; i < n_; ++i) {
      // What a hinge is short of, in its own unit: what the load gives it.
      const double unit = std::abs(rates.per_load[i]);
      rest_[i] = shortfall(i, trial) * (unit > 0 ? unit : 1);
      basic_[i] = {i, Kind::rests};
      other_[i] = {i, Kind::goes_on};
    }
    other_[n_] = {n_, Kind::load};
  }

  /// The ray at which the walk ends.
  std::optional<RateRay> walk(double direction) {
    constexpr Index most = 20, few = 50;
    Index driving = n_;
    for (Index pivots = 0; pivots < most * n_ + few; ++pivots) {
      const Index first = blocking(driving);
      if (first < 0) return ray(driving, direction);
      const Variable leaving = basic_[first];
      pivot(first, driving);
      driving = place_of({leaving.hinge, leaving.kind == Kind::rests ? Kind::goes_on : Kind::rests});
      if (is_back(driving)) return {};
    }
    return {};
  }

 private:
  enum class Kind { rests, goes_on, load };
  struct Variable {
    Index hinge = 0;
    Kind kind = Kind::rests;
    friend bool operator==(const Variable&, const Variable&) = default;
  };

  /// Whether the walk has come round to the piece on which all hinges rest and from which it set out.
  bool is_back(Index driving) const {
    return other_[driving].kind == Kind::rests &&
           std::ranges::none_of(basic_, [](const Variable& v) { return v.kind == Kind::goes_on; });
  }

  /// The row whose variable comes to nothing first while another one grows; −1 when none does.
  Index blocking(Index driving) const {
    constexpr double round_off = 1e-11;
    const double least = round_off * table_.col(driving).lpNorm<Eigen::Infinity>();
    Index first = -1;
    for (Index i = 0; i < n_; ++i) {
      if (basic_[i].kind == Kind::load || table_(i, driving) >= -least) continue;
      if (first < 0 || rest_[i] * table_(first, driving) > rest_[first] * table_(i, driving)) first = i;
    }
    return first;
  }

  /// Exchanges a basic variable for another one.
  void pivot(Index row, Index column) {
    const double at = table_(row, column);
    Eigen::RowVectorXd of_row = -table_.row(row) / at;
    of_row[column] = 1 / at;
    const double rest = -rest_[row] / at;
    const Vector of_column = table_.col(column);
    table_.col(column).setZero();
    table_.noalias() += of_column * of_row;
    rest_ += rest * of_column;
    table_.row(row) = of_row;
    rest_[row] = rest;
    std::swap(basic_[row], other_[column]);
  }

  Index place_of(const Variable& wanted) const {
    for (Index j = 0; j <= n_; ++j)
      if (other_[j] == wanted) return j;
    return n_;
  }

  RateRay ray(Index driving, double direction) const {
    RateRay out{std::vector<bool>(static_cast<std::size_t>(n_), false), direction};
    const auto mark = [&](const Variable& v) {
      if (v.kind == Kind::goes_on) out.goes_on[static_cast<std::size_t>(v.hinge)] = true;
    };
    mark(other_[driving]);
    for (Index i = 0; i < n_; ++i) {
      mark(basic_[i]);
      if (basic_[i].kind == Kind::load) out.load_factor = direction * table_(i, driving);
    }
    return out;
  }

  Index n_;
  Matrix table_;  ///< rows of basic variables, columns of the others
  Vector rest_;   ///< of basic variables, from p
  std::vector<Variable> basic_, other_;
};

}  // namespace

std::optional<RateRay> follow_hinges(const HingedRates& rates, double direction) {
  constexpr int most_trials = 32;
  for (int trial = 0; trial < most_trials; ++trial)
    if (auto ray = Tableau(rates, direction, trial).walk(direction)) return ray;
  return {};
}

}  // namespace dda
