#include "continuation/contact/contact_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/contact/changing_inverse.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Eigen::Index place(std::size_t point) { return 2 * static_cast<Eigen::Index>(point); }

/// A number in (1, 1.3) that belongs to an index: breaks ties, and repeats.
double tie_breaker(std::size_t index) {
  const double golden = 0.6180339887498949 * static_cast<double>(index + 1);
  return 1 + 0.3 * (golden - std::floor(golden));
}

class Walk {
 public:
  explicit Walk(const ContactProblem& problem)
      : problem_(problem), pieces_(size(), ContactPiece::stuck), centre_(Vector::Zero(2 * count())) {}

  std::optional<Vector> from(const Vector& start) {
    x_ = start;
    centre_ = openings(start);
    disturb(residual(x_, problem_.residual_share).lpNorm<Eigen::Infinity>());
    read_pieces();
    tau_ = 1;
    const std::size_t most = problem_.corrects ? most_near * size() : size() / 2;
    return follow(residual(x_, problem_.residual_share), most + few);
  }

  std::optional<Vector> covered() {
    for (std::size_t i = 0; i < size(); ++i)
      if (const auto& contact = problem_.points[i].contact)
        pieces_[i] = contact->coefficient > 0 ? ContactPiece::stuck : ContactPiece::forward;
    x_ = Vector::Zero(problem_.constant.size());
    if (!factor()) return {};
    x_ -= inverse_.solve(residual(x_, problem_.residual_share));
    Vector overlap = Vector::Zero(x_.size());
    for (std::size_t i = 0; i < size(); ++i)
      if (problem_.points[i].contact) overlap[place(i)] = -tie_breaker(i);
    tau_ = covering(overlap);
    x_ += tau_ * overlap;
    return follow(times(overlap), most_covered * size() + few);
  }

 private:
  /// Corners a walk may pass, per point and beside: one that passes more wanders.
  static constexpr std::size_t most_near = 2, most_covered = 12, few = 200;

  std::size_t size() const { return problem_.points.size(); }
  Eigen::Index count() const { return static_cast<Eigen::Index>(size()); }
  Vec2 opening(const Vector& x, std::size_t i) const { return x.segment<2>(place(i)); }

  /// Traction and tangent of a point on its piece, its residual stiffness included.
  Response respond(std::size_t i, const Vec2& q, double share) const {
    const ContactProblem::Point& point = problem_.points[i];
    if (!point.contact) return {point.traction + point.tangent * q, point.tangent};
    Response out = response_on(*point.contact, pieces_[i], q);
    const Mat2 trial = point.trial.asDiagonal();
    const Vec2 opened = trial * q - out.traction - trial * centre_.segment<2>(place(i));
    out.traction += share * opened;
    out.tangent += share * (trial - out.tangent);
    return out;
  }

  /// w = q − P⁻¹ t of all points.
  Vector openings(const Vector& x) {
    read_pieces_at(x);
    Vector out = Vector::Zero(2 * count());
    for (std::size_t i = 0; i < size(); ++i) {
      const Vec2 q = opening(x, i);
      out.segment<2>(place(i)) = q - respond(i, q, 0).traction.cwiseQuotient(problem_.points[i].trial);
    }
    return out;
  }

  Vector residual(const Vector& x, double share) const {
    Vector z(2 * count());
    for (std::size_t i = 0; i < size(); ++i) {
      const ContactProblem::Point& point = problem_.points[i];
      const Vec2 q = opening(x, i);
      z.segment<2>(place(i)) =
          point.weight * (respond(i, q, share).traction - point.base * (q - point.multiplier));
    }
    const Eigen::Index last = 2 * count();
    Vector out = problem_.constant + problem_.couplings * z;
    out.head(last) += x.head(last) - x[last] * problem_.live;
    out[last] += problem_.control.dot(x);
    return out;
  }

  Mat2 change_of(std::size_t i) const {
    const ContactProblem::Point& point = problem_.points[i];
    return point.weight * (respond(i, Vec2::Zero(), problem_.residual_share).tangent - point.base);
  }

  /// ∂F/∂x: the unit matrix but for the points that are not as in the base, the load factor and the control.
  bool factor() {
    std::vector<Mat2> changes;
    std::vector<Eigen::Index> places;
    for (std::size_t i = 0; i < size(); ++i) {
      const Mat2 change = change_of(i);
      if (change.isZero(0)) continue;
      changes.push_back(change);
      places.insert(places.end(), {place(i), place(i) + 1});
    }
    const Eigen::Index last = 2 * count();
    places.push_back(last);
    Matrix columns(last + 1, std::ssize(places));
    for (std::size_t a = 0; a < changes.size(); ++a) {
      const Eigen::Index at = places[2 * a];
      auto pair = columns.middleCols<2>(place(a));
      pair = problem_.couplings.middleCols<2>(at).lazyProduct(changes[a]);
      pair.middleRows<2>(at) += Mat2::Identity();
      pair.row(last) += problem_.control.segment<2>(at).transpose();
    }
    columns.rightCols(1) << -problem_.live, problem_.control[last];
    return inverse_.factor(std::move(columns), std::move(places), problem_.control);
  }

  /// ∂F/∂x v of a v without load factor.
  Vector times(const Vector& v) const {
    Vector z(2 * count());
    for (std::size_t i = 0; i < size(); ++i) z.segment<2>(place(i)) = change_of(i) * opening(v, i);
    Vector out = v + problem_.couplings * z;
    out[2 * count()] += problem_.control.dot(v);
    return out;
  }

  void read_pieces() { read_pieces_at(x_); }
  void read_pieces_at(const Vector& x) {
    for (std::size_t i = 0; i < size(); ++i)
      if (const auto& contact = problem_.points[i].contact)
        pieces_[i] = piece_at(*contact, opening(x, i), problem_.points[i].slides);
  }

  /// Off all corners by next to nothing, so that no two points cross theirs at once: by a small part of what
  /// is left of F, so that walks that follow each other settle.
  void disturb(double left) {
    constexpr double little = 1e-6, part = 0.01;
    const double most = little * x_.head(2 * count()).lpNorm<Eigen::Infinity>();
    for (Eigen::Index i = 0; i < 2 * count(); ++i)
      x_[i] += std::min(most, part * left) * (tie_breaker(static_cast<std::size_t>(i)) - 1.15);
  }

  /// An overlap at which all joints are closed and held.
  double covering(const Vector& overlap) const {
    double out = 0, largest = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const auto& contact = problem_.points[i].contact;
      if (!contact) continue;
      const Vec2 q = opening(x_, i);
      const double lever =
          contact->coefficient > 0 ? std::abs(q.y() - contact->slip) / contact->coefficient : 0;
      out = std::max(out, (q.x() + lever) / -overlap[place(i)]);
      largest = std::max(largest, q.norm());
    }
    return 1.1 * out + largest;
  }

  /// Along F(x) = τ r to τ = 0, past not more than `most` corners, then corrected until F is met as it is.
  std::optional<Vector> follow(const Vector& right, std::size_t most) {
    if (!refactor(right)) return {};
    direction_ = -1;
    last_ = -1;
    for (std::size_t corners = 0; corners < most; ++corners) {
      const Vector along = direction_ * way_;
      const auto end = next_end(along);
      const double rest = direction_ < 0 ? tau_ : std::numeric_limits<double>::infinity();
      if (!end || end->length >= rest) {
        if (!std::isfinite(rest)) return {};  // a ray: nothing holds what moves
        x_ += rest * along;
        return problem_.corrects ? corrected() : std::optional(x_);
      }
      x_ += end->length * along;
      tau_ += direction_ * end->length;
      if (!cross(end->point, end->to, right)) return {};
    }
    return {};
  }

  bool refactor(const Vector& right) {
    if (!factor()) return false;
    way_ = inverse_.solve(right);
    return way_.allFinite();
  }

  struct NextEnd {
    double length;
    std::size_t point;
    ContactPiece to;
  };
  std::optional<NextEnd> next_end(const Vector& along) const {
    std::optional<NextEnd> out;
    for (std::size_t i = 0; i < size(); ++i) {
      const auto& contact = problem_.points[i].contact;
      if (!contact) continue;
      const auto end = end_of_piece(*contact, pieces_[i], opening(x_, i), along.segment<2>(place(i)));
      if (!end || (out && end->length >= out->length)) continue;
      if (static_cast<int>(i) == last_ && end->to == left_ && is_here(i, end->length, along)) continue;
      out = NextEnd{end->length, i, end->to};
    }
    return out;
  }
  /// Whether a corner is no farther than rounding.
  bool is_here(std::size_t i, double length, const Vector& along) const {
    constexpr double round_off = 1e-10;
    return length * opening(along, i).norm() <= round_off * opening(x_, i).norm();
  }

  bool cross(std::size_t i, ContactPiece to, const Vector& right) {
    const ContactProblem::Point& point = problem_.points[i];
    const PieceChange change = change_between(*point.contact, pieces_[i], to);
    const Vector u = problem_.couplings.middleCols<2>(place(i)) *
                     ((1 - problem_.residual_share) * point.weight * change.u);
    last_ = static_cast<int>(i);
    left_ = pieces_[i];
    pieces_[i] = to;
    const double ratio = inverse_.add(u, place(i), change.v);
    if (ratio < 0) direction_ = -direction_;
    constexpr double singular = 1e-11;
    constexpr std::size_t most_changes = 100;
    if (std::abs(ratio) < singular || inverse_.num_changes() >= most_changes) return refactor(right);
    inverse_.update(way_);
    return way_.allFinite();
  }

  /// Proximal corrections on the pieces that were found, until the equations hold as they are.
  std::optional<Vector> corrected() {
    if (!factor()) return {};
    double before = std::numeric_limits<double>::infinity();
    Vector best = x_;
    for (int correction = 0; correction < 12; ++correction) {
      const Vector rest = residual(x_, 0);
      const double error = rest.lpNorm<Eigen::Infinity>();
      if (!(error < before)) return best;
      best = x_;
      if (error <= problem_.accuracy || (correction > 3 && error > 0.5 * before)) return best;
      before = error;
      x_ -= inverse_.solve(rest);
    }
    return best;
  }

  const ContactProblem& problem_;
  std::vector<ContactPiece> pieces_;
  Vector centre_;  ///< w that the residual stiffness pulls to
  Vector x_, way_;
  double tau_ = 1, direction_ = -1;
  ChangingInverse inverse_;
  int last_ = -1;                            ///< point that crossed last
  ContactPiece left_ = ContactPiece::stuck;  ///< the piece it came from
};

}  // namespace

std::optional<Vector> walk_from(const ContactProblem& problem, const Vector& start) {
  return Walk(problem).from(start);
}

std::optional<Vector> walk_proximally(ContactProblem problem, Vector start) {
  constexpr double firm = 0.1, more = 10, most = 1, at_rest = 0.1;
  constexpr int most_walks = 150;
  const double wanted = problem.residual_share;
  double& share = problem.residual_share;
  share = std::max(firm, more * wanted);
  const Eigen::Index last = start.size() - 1;
  double moved = 0, moved_then = 0;
  int patience = 1, stays = 0;
  bool is_trial = false;
  for (int walks = 0; walks < most_walks && share <= most; ++walks) {
    problem.corrects = share <= wanted;
    const auto found = walk_from(problem, start);
    if (!found) {
      if (is_trial) patience *= 2;
      moved_then = moved;
      stays = 0;
      is_trial = false;
      share *= more;
      continue;
    }
    if (share <= wanted) return found;
    moved = (*found - start).head(last).lpNorm<Eigen::Infinity>();
    start = *found;
    is_trial = ++stays >= patience || moved <= at_rest * moved_then;
    if (!is_trial) continue;
    share = std::max(wanted, share / more);
    stays = 0;
  }
  return {};
}

std::optional<Vector> walk_covered(const ContactProblem& problem) { return Walk(problem).covered(); }

}  // namespace dda
