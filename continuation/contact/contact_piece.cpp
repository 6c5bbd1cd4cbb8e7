#include "continuation/contact/contact_piece.hpp"

#include <algorithm>
#include <cmath>

#include "models/interface/coulomb.hpp"

namespace dda {
namespace {

/// q as the pieces see it.
Vec2 seen(const Contact& c, const Vec2& q) { return {q.x() + c.shift, q.y()}; }

double sign_of(ContactPiece piece) { return piece == ContactPiece::backward ? -1 : 1; }

/// Beyond the limit of friction in a direction, where positive [L].
double excess(const Contact& c, double direction, const Vec2& x) {
  return direction * (x.y() - c.slip) + c.coefficient * x.x();
}

/// Length to where a value that is negative on its piece has grown to 0; nothing when it does not grow.
std::optional<double> length_to_zero(double value, double rate) {
  if (!(rate > 0)) return {};
  return std::max(0.0, -value / rate);
}

void take_first(std::optional<PieceEnd>& first, std::optional<double> length, ContactPiece to) {
  if (length && (!first || *length < first->length)) first = PieceEnd{*length, to};
}

}  // namespace

ContactPiece piece_at(const Contact& c, const Vec2& trial, bool slides) {
  const Vec2 q = seen(c, trial);
  if (q.x() > 0) return ContactPiece::open;
  if (c.coefficient == 0) return ContactPiece::forward;
  const double direction = q.y() < c.slip ? -1 : 1, over = excess(c, direction, q);
  if (over <= (slides ? -at_limit_from : beyond_limit) * c.coefficient * std::abs(q.x()))
    return ContactPiece::stuck;
  return direction < 0 ? ContactPiece::backward : ContactPiece::forward;
}

Response response_on(const Contact& c, ContactPiece piece, const Vec2& trial) {
  const Vec2 q = seen(c, trial);
  Response out;
  out.tangent(0, 0) = piece == ContactPiece::open ? c.open : c.closed;
  out.tangent(1, 1) = c.shear;
  if (piece == ContactPiece::stuck) out.tangent(1, 1) += c.friction;
  if (piece == ContactPiece::forward || piece == ContactPiece::backward)
    out.tangent(1, 0) = -sign_of(piece) * c.friction * c.coefficient;
  out.traction = out.tangent * q - Vec2(c.pressure, 0);
  if (piece == ContactPiece::stuck) out.traction.y() -= c.friction * c.slip;
  return out;
}

std::optional<PieceEnd> end_of_piece(const Contact& c, ContactPiece piece, const Vec2& trial,
                                     const Vec2& along) {
  const Vec2 q = seen(c, trial);
  std::optional<PieceEnd> first;
  const auto over = [&](double direction) { return excess(c, direction, q); };
  const auto rate = [&](double direction) { return direction * along.y() + c.coefficient * along.x(); };
  if (piece == ContactPiece::open) {
    const auto length = length_to_zero(-q.x(), -along.x());
    const double met = length ? q.y() + *length * along.y() - c.slip : 0;
    take_first(first, length, c.coefficient > 0 && met < 0 ? ContactPiece::backward : ContactPiece::forward);
  } else if (piece == ContactPiece::stuck) {
    take_first(first, length_to_zero(over(1), rate(1)), ContactPiece::forward);
    take_first(first, length_to_zero(over(-1), rate(-1)), ContactPiece::backward);
  } else {
    const double direction = sign_of(piece);
    if (c.coefficient > 0)
      take_first(first, length_to_zero(-over(direction), -rate(direction)), ContactPiece::stuck);
    take_first(first, length_to_zero(q.x(), along.x()), ContactPiece::open);
  }
  return first;
}

PieceChange change_between(const Contact& c, ContactPiece from, ContactPiece to) {
  if (from == ContactPiece::open || to == ContactPiece::stuck) {
    const PieceChange back = change_between(c, to, from);
    return {-back.u, back.v};
  }
  if (from == ContactPiece::stuck) return {Vec2(0, -c.friction), Vec2(sign_of(to) * c.coefficient, 1)};
  return {Vec2(c.open - c.closed, sign_of(from) * c.friction * c.coefficient), Vec2(1, 0)};
}

}  // namespace dda
