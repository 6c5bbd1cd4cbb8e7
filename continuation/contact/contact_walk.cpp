#include "continuation/contact/contact_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>

#include "continuation/linear/dense/two_by_two.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// A number in (1, 1.3) that belongs to an index: breaks ties, and repeats.
double tie_breaker(std::size_t index) {
  const double golden = 0.6180339887498949 * static_cast<double>(index + 1);
  return 1 + 0.3 * (golden - std::floor(golden));
}

/// A random number that belongs to a point on a piece: sums of them tell sets of pieces apart.
std::uint64_t mark_of(std::size_t point, ContactPiece piece) {
  std::uint64_t z = 0x9e3779b97f4a7c15ull * (4 * point + static_cast<std::uint64_t>(piece) + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// Corners that a walk may pass before it is said to wander, and how many of them after it has first turned round.
struct Limits {
  std::size_t all, after_turn;
};

// The last of a walk that ends by itself, and of a search by many walks.
constexpr std::size_t few = 200, per_point = 2, many_per_point = 20;

std::size_t many_corners(std::size_t points) { return many_per_point * points + few; }
Limits limits_of(Patience patience, std::size_t points) {
  const std::size_t all = per_point * points + few;
  return {all, patience == Patience::little ? few : all};
}

/// How a point at a corner is read: as on the piece on which it has come to stand, or on the one it is moved onto.
enum class Corners { as_they_came, as_they_lie };

class Walk {
 public:
  Walk(const ContactProblem& problem, ContactMatrix& matrix, const WalkRule& rule)
      : problem_(problem),
        matrix_(matrix),
        rule_(rule),
        pieces_(size(), ContactPiece::stuck),
        centre_(Vector::Zero(2 * count())) {}

  std::optional<Vector> from(const Vector& start, Corners corners) {
    x_ = start;
    corners_ = corners;
    set_centre(start);
    disturb(residual(x_, rule_.share).lpNorm<Eigen::Infinity>());
    read_pieces();
    tau_ = 1;
    return follow(residual(x_, rule_.share), limits_of(rule_.patience, size()));
  }

  std::optional<Vector> covered() {
    for (std::size_t i = 0; i < size(); ++i)
      if (const auto& contact = problem_.points[i].contact)
        pieces_[i] = contact->coefficient > 0 ? ContactPiece::stuck : ContactPiece::forward;
    x_ = Vector::Zero(problem_.constant.size());
    if (!matrix_.move_to(problem_, changes())) return {};
    x_ -= matrix_.solve(residual(x_, rule_.share));
    Vector overlap = Vector::Zero(x_.size());
    for (std::size_t i = 0; i < size(); ++i)
      if (problem_.points[i].contact) overlap[pair_at(i)] = -tie_breaker(i);
    tau_ = covering(overlap);
    x_ += tau_ * overlap;
    // Ends by itself, but where strong friction wedges bricks many joints are let go and held again on the way.
    return follow(times(overlap), {many_corners(size()), many_corners(size())});
  }

 private:
  std::size_t size() const { return problem_.points.size(); }
  Eigen::Index count() const { return static_cast<Eigen::Index>(size()); }
  Vec2 opening(const Vector& x, std::size_t i) const { return x.segment<2>(pair_at(i)); }

  /// What is left of a point's traction t and what is added: a t + b P (q − c).
  struct Residual {
    double of_law = 1, of_spring = 0;
  };
  /// The residual stiffness below ε = 1: ε P (q − w₀) beside (1 − ε) t with w₀ = q₀ − P⁻¹ t₀, which changes
  /// nothing of what sticks. From ε = 1 on it is ε P (q − q₀) beside all of t, more firm than friction can
  /// push; where q has an exact multiplier in it the former, with ε/(1 + ε), is a spring ε P against what opens
  /// and slides.
  Residual residual_of(std::size_t i, double share) const {
    if (share < 1) return {1 - share, share};
    if (!problem_.points[i].is_exact) return {1, share};
    return {1 / (1 + share), share / (1 + share)};
  }
  bool holds_jump(std::size_t i) const { return rule_.share >= 1 && !problem_.points[i].is_exact; }

  /// Traction and tangent of a point on its piece, its residual stiffness included.
  Response respond(std::size_t i, const Vec2& q, double share) const {
    const ContactProblem::Point& point = problem_.points[i];
    if (!point.contact) return {point.traction + point.tangent * q, point.tangent};
    const Response now = response_on(*point.contact, pieces_[i], q);
    const Mat2 trial = point.trial.asDiagonal();
    const Residual r = residual_of(i, share);
    return {r.of_law * now.traction + r.of_spring * (trial * (q - centre_.segment<2>(pair_at(i)))),
            r.of_law * now.tangent + r.of_spring * trial};
  }

  /// Sets the centres c of all points: w₀ = q₀ − P⁻¹ t₀, or q₀.
  void set_centre(const Vector& start) {
    read_pieces_at(start);
    for (std::size_t i = 0; i < size(); ++i) {
      const Vec2 q = opening(start, i);
      const Vec2 held = respond(i, q, 0).traction.cwiseQuotient(problem_.points[i].trial);
      centre_.segment<2>(pair_at(i)) = holds_jump(i) ? q : Vec2(q - held);
    }
  }

  Vector residual(const Vector& x, double share) const {
    Vector z(2 * count());
    for (std::size_t i = 0; i < size(); ++i) {
      const ContactProblem::Point& point = problem_.points[i];
      const Vec2 q = opening(x, i);
      z.segment<2>(pair_at(i)) =
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
    return point.weight * (respond(i, Vec2::Zero(), rule_.share).tangent - point.base);
  }

  std::vector<Mat2> changes() const {
    std::vector<Mat2> out(size());
    for (std::size_t i = 0; i < size(); ++i) out[i] = change_of(i);
    return out;
  }

  /// ∂F/∂x v of a v without load factor.
  Vector times(const Vector& v) const {
    Vector z(2 * count());
    for (std::size_t i = 0; i < size(); ++i) z.segment<2>(pair_at(i)) = change_of(i) * opening(v, i);
    Vector out = v + problem_.couplings * z;
    out[2 * count()] += problem_.control.dot(v);
    return out;
  }

  void read_pieces() { read_pieces_at(x_); }
  void read_pieces_at(const Vector& x) {
    for (std::size_t i = 0; i < size(); ++i)
      if (problem_.points[i].contact) pieces_[i] = piece_of(i, opening(x, i));
  }
  ContactPiece piece_of(std::size_t i, const Vec2& q) const {
    const ContactProblem::Point& point = problem_.points[i];
    return piece_at(*point.contact, q, point.slides && corners_ == Corners::as_they_came);
  }

  /// Moves x off all corners by next to nothing, so that no two points cross theirs at once, nor one goes back over that
  /// beyond which it has come to stand: by a small part of what is left of F, so that walks that follow each other
  /// settle.
  void disturb(double left) {
    constexpr double little = 1e-6, part = 0.01;
    const double most = little * x_.head(2 * count()).lpNorm<Eigen::Infinity>(),
                 far = std::min(most, part * left);
    for (std::size_t i = 0; i < size(); ++i) {
      const auto of = [&](std::size_t k) { return far * (tie_breaker(k) - 1.15); };
      x_.segment<2>(pair_at(i)) += within_piece(i, {of(2 * i), of(2 * i + 1)});
    }
  }
  /// An amount by which a point may move, turned so that one that is open or slides goes on to if any turn does.
  Vec2 within_piece(std::size_t i, const Vec2& by) const {
    if (corners_ == Corners::as_they_lie || !problem_.points[i].contact || pieces_[i] == ContactPiece::stuck)
      return by;
    for (const Vec2& turned : {by, Vec2(-by), Vec2(by.x(), -by.y()), Vec2(-by.x(), by.y())})
      if (piece_of(i, opening(x_, i) + turned) == pieces_[i]) return turned;
    return by;
  }

  /// How many times `overlap` closes and holds all joints.
  double covering(const Vector& overlap) const {
    double out = 0, largest = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const auto& contact = problem_.points[i].contact;
      if (!contact) continue;
      const Vec2 q = opening(x_, i);
      const double lever =
          contact->coefficient > 0 ? std::abs(q.y() - contact->slip) / contact->coefficient : 0;
      out = std::max(out, (q.x() + lever) / -overlap[pair_at(i)]);
      largest = std::max(largest, q.norm());
    }
    return 1.1 * out + largest;
  }

  /// Follows F(x) = τ r to τ = 0 and corrects until F is met as it is. On one set of pieces there is one line of
  /// solutions: a set that comes back closes a loop that never ends.
  std::optional<Vector> follow(const Vector& right, const Limits& limits) {
    if (!set_out(right)) return {};
    const double distance = tau_ * right.lpNorm<Eigen::Infinity>();
    std::unordered_set<std::uint64_t> passed;
    std::uint64_t set = 0;  // of the pieces that are others than at the start
    std::size_t after_turn = 0;
    for (std::size_t corners = 0; corners < limits.all && after_turn < limits.after_turn; ++corners) {
      if (!passed.insert(set).second || rule_.gives_up()) return {};
      const Vector along = direction_ * way_;
      const auto end = next_end(along);
      const double rest = direction_ < 0 ? tau_ : std::numeric_limits<double>::infinity();
      if (!end || end->length >= rest) {
        if (!std::isfinite(rest)) return {};  // a ray: nothing holds what moves
        x_ += rest * along;
        return rule_.is_taken_off ? corrected() : std::optional(x_);
      }
      x_ += end->length * along;
      tau_ += direction_ * end->length;
      set += mark_of(end->point, end->to) - mark_of(end->point, pieces_[end->point]);
      const bool came_nearer = direction_ < 0;
      if (!cross(end->point, end->to, right)) return {};
      if (after_turn > 0 || direction_ > 0) ++after_turn;
      if (!came_nearer || direction_ < 0 || tau_ >= nearest_) continue;
      nearest_ = tau_;
      if (auto found = solved_nearby(distance)) return found;
      if (!matrix_.move_to(problem_, changes())) return {};
    }
    return {};
  }

  bool set_out(const Vector& right) {
    if (!matrix_.move_to(problem_, changes())) return false;
    way_ = matrix_.solve(right);
    direction_ = -1;
    nearest_ = tau_;
    last_ = -1;
    return way_.allFinite();
  }

  /// Where the way turns round, the equations with the residual stiffness have no solution nearer. As they are
  /// they may have one all the same: at the load of a mechanism joints stand at their limits, and nothing
  /// bears the little that moving against that stiffness takes. From here by Newton's method over the pieces,
  /// without it, as near as it gets: weak springs may be too much to bear as well, and what they leave the full
  /// equations judge. `size` of what walking has to bring to 0.
  std::optional<Vector> solved_nearby(double size) {
    if (!rule_.is_taken_off) return {};
    constexpr int most = 8;
    constexpr double near = 1e-3, solved = 1e3, nearly = 1e6;
    const Vector turn = x_;
    const std::vector<ContactPiece> pieces = pieces_;
    Vector best;
    double least = nearly * problem_.accuracy;
    for (int iteration = 0; iteration < most; ++iteration) {
      x_ = *corrected();
      read_pieces();
      const double left = residual(x_, 0).lpNorm<Eigen::Infinity>();
      if (left < least) {
        best = x_;
        least = left;
      }
      if (least <= solved * problem_.accuracy || !(left <= near * size)) break;
      if (!matrix_.move_to(problem_, changes())) break;
    }
    if (best.size() > 0) return best;
    x_ = turn;
    pieces_ = pieces;
    return {};
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
      const auto end = end_of_piece(*contact, pieces_[i], opening(x_, i), along.segment<2>(pair_at(i)));
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
    last_ = static_cast<int>(i);
    left_ = pieces_[i];
    pieces_[i] = to;
    const double by = residual_of(i, rule_.share).of_law * point.weight;
    if (matrix_.add(problem_, {i, by * change.u, change.v, change_of(i)}) < 0) direction_ = -direction_;
    if (!matrix_.is_worn()) {
      matrix_.update(way_);
    } else {
      if (!matrix_.factor(problem_, changes())) return false;
      way_ = matrix_.solve(right);
    }
    return way_.allFinite();
  }

  /// Proximal corrections on the pieces that were found, until the equations hold as they are.
  std::optional<Vector> corrected() {
    double before = std::numeric_limits<double>::infinity();
    Vector best = x_;
    for (int correction = 0; correction < 12; ++correction) {
      const Vector rest = residual(x_, 0);
      const double error = rest.lpNorm<Eigen::Infinity>();
      if (!(error < before)) return best;
      best = x_;
      if (error <= problem_.accuracy || (correction > 3 && error > 0.5 * before)) return best;
      before = error;
      x_ -= matrix_.solve(rest);
    }
    return best;
  }

  const ContactProblem& problem_;
  ContactMatrix& matrix_;
  const WalkRule rule_;
  Corners corners_ = Corners::as_they_came;
  std::vector<ContactPiece> pieces_;
  Vector centre_;  ///< w that the residual stiffness pulls to
  Vector x_, way_;
  double tau_ = 1, direction_ = -1;
  double nearest_ = 1;                       ///< least τ at which the way has turned round
  int last_ = -1;                            ///< point that crossed last
  ContactPiece left_ = ContactPiece::stuck;  ///< the piece it came from
};

}  // namespace

std::optional<Vector> walk_from(const ContactProblem& problem, const Vector& start, ContactMatrix& matrix,
                                const WalkRule& rule) {
  auto found = Walk(problem, matrix, rule).from(start, Corners::as_they_came);
  if (found || rule.patience == Patience::little) return found;
  return Walk(problem, matrix, rule).from(start, Corners::as_they_lie);
}

std::optional<Vector> walk_proximally(const ContactProblem& problem, Vector start, ContactMatrix& matrix,
                                      const WalkRule& rule) {
  constexpr double firm = 0.1, at_rest = 0.1, far = 100;
  constexpr int most_walks = 1000;
  const double wanted = rule.share;
  constexpr int firmest = -1;
  int level = 1;  // of the share, in powers of `firm`
  const Eigen::Index last = start.size() - 1;
  const Vector origin = start;
  const double size =
      std::max({start.head(last).lpNorm<Eigen::Infinity>(), problem.constant.lpNorm<Eigen::Infinity>(),
                std::abs(start[last]) * problem.live.lpNorm<Eigen::Infinity>()});
  double moved = 0, moved_then = 0;
  int patience = 1, stays = 0;
  bool is_trial = false;
  const std::size_t most = matrix.num_changes() + many_corners(problem.points.size());
  for (int walks = 0; walks < most_walks && level >= firmest && matrix.num_changes() <= most; ++walks) {
    const double share = std::max(wanted, std::pow(firm, level));
    const auto found =
        walk_from(problem, start, matrix, {share, share <= wanted, Patience::little, rule.is_over});
    if (!found) {
      if (is_trial) patience *= 2;
      moved_then = moved;
      stays = 0;
      is_trial = false;
      --level;
      continue;
    }
    if (share <= wanted) return found;
    moved = (*found - start).head(last).lpNorm<Eigen::Infinity>();
    start = *found;
    if (!((start - origin).head(last).lpNorm<Eigen::Infinity>() <= far * size))
      return {};  // nothing holds it
    is_trial = ++stays >= patience || moved <= at_rest * moved_then;
    if (!is_trial) continue;
    ++level;
    stays = 0;
  }
  return {};
}

std::optional<Vector> walk_covered(const ContactProblem& problem, ContactMatrix& matrix,
                                   const WalkRule& rule) {
  return Walk(problem, matrix, rule).covered();
}

}  // namespace dda
