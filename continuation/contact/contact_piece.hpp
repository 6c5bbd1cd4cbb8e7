#pragma once

#include <optional>

#include "models/interface/law.hpp"

namespace dda {

/// The four linear pieces of a joint in contact: apart, held by friction, sliding to either side of its slip.
/// Without friction a closed joint always slides forward.
enum class ContactPiece { open, stuck, forward, backward };

/// The piece on which q lies; at a corner the one that goes with `slides`.
ContactPiece piece_at(const Contact& contact, const Vec2& q, bool slides);

/// Traction and tangent of a piece, whether q lies on it or beyond its ends.
Response response_on(const Contact& contact, ContactPiece piece, const Vec2& q);

/// Where a piece ends along a ray.
struct PieceEnd {
  double length;    ///< along the ray, 0 where q is at the end or just beyond it
  ContactPiece to;  ///< the piece behind
};

std::optional<PieceEnd> end_of_piece(const Contact& contact, ContactPiece piece, const Vec2& q,
                                     const Vec2& along);

/// tangent(to) − tangent(from) = u vᵀ of two pieces with a common end.
struct PieceChange {
  Vec2 u, v;
};
PieceChange change_between(const Contact& contact, ContactPiece from, ContactPiece to);

}  // namespace dda
