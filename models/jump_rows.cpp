#include "models/jump_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "models/body/motion.hpp"

namespace dda {
namespace {

/// A piece of a line, and the jumps by which what lies behind it moves beside what lies before it.
struct MovedPiece {
  Vec2 start, end;
  std::vector<std::pair<JumpId, double>> jumps;  ///< with their signs
};

/// [n s]ᵀ.
Mat2 frame(const Vec2& normal) {
  Mat2 out;
  out << normal.x(), normal.y(), -normal.y(), normal.x();
  return out;
}

class Along {
 public:
  Along(const Body& body, const PointLine& line, const std::vector<MovedPiece>& pieces)
      : body_(body), line_(line), edge_(line.end - line.start) {
    for (const MovedPiece& piece : pieces)
      for (const auto& [jump, sign] : piece.jumps) moved_[jump].push_back({&piece, sign});
    num_pieces_ = pieces.size();
  }

  JumpsOfPoints rows() const {
    JumpsOfPoints out(line_.points.size());
    for (const auto& [jump, pieces] : moved_)
      for (std::size_t i = 0; i < out.size(); ++i) out[i].push_back(rows_of(jump, pieces, i));
    return out;
  }

 private:
  using Pieces = std::vector<std::pair<const MovedPiece*, double>>;

  JumpRows rows_of(JumpId jump, const Pieces& pieces, std::size_t i) const {
    if (pieces.size() == num_pieces_) {
      const NodeMotion motion = motion_of(body_, jump, line_.start + line_.points[i].first * edge_);
      return {motion.node, pieces.front().second * frame(line_.normal) * motion.rows};
    }
    JumpRows out{body_.node_of(jump), Mat26::Zero()};
    for (const auto& [piece, sign] : pieces) out.rows += sign * mean_over(*piece, jump, i);
    return out;
  }

  /// Gauss points are exact for the product of two linear functions.
  Mat26 mean_over(const MovedPiece& piece, JumpId jump, std::size_t i) const {
    const double whole = edge_.norm(), share = (piece.end - piece.start).norm() / whole;
    const double g = 0.5 / std::sqrt(3.0);
    Mat26 out = Mat26::Zero();
    for (const double at : {0.5 - g, 0.5 + g}) {
      const Vec2 x = piece.start + at * (piece.end - piece.start);
      out += share / 2 * weight((x - line_.start).dot(edge_) / (whole * whole), i) * frame(line_.normal) *
             motion_of(body_, jump, x).rows;
    }
    return out / line_.points[i].second;
  }

  /// N_i, Lagrange's polynomial of the points.
  double weight(double xi, std::size_t i) const {
    double out = 1;
    for (std::size_t j = 0; j < line_.points.size(); ++j)
      if (const double own = line_.points[i].first, other = line_.points[j].first; j != i)
        out *= (xi - other) / (own - other);
    return out;
  }

  const Body& body_;
  const PointLine& line_;
  Vec2 edge_;
  std::map<JumpId, Pieces> moved_;
  std::size_t num_pieces_ = 0;
};

}  // namespace

JumpsOfPoints jumps_along_side(const Body& body, std::size_t side, const PointLine& line) {
  if (body.num_jumps() == 0 || !body.cracks->is_touched(side)) return JumpsOfPoints(line.points.size());
  std::vector<MovedPiece> pieces;
  for (const SidePiece& piece : body.cracks->pieces_of_side(side)) {
    if (distance((piece.start + piece.end) / 2, line.start, line.end) > body.cracks->tolerance()) continue;
    MovedPiece moved{piece.start, piece.end, {}};
    for (const JumpId jump : piece.first) moved.jumps.emplace_back(jump, -1);
    for (const JumpId jump : piece.second) moved.jumps.emplace_back(jump, 1);
    pieces.push_back(std::move(moved));
  }
  return Along(body, line, pieces).rows();
}

JumpsOfPoints jumps_along_cut(const Body& body, const Cut& cut, const PointLine& line) {
  std::vector<MovedPiece> pieces;
  for (const auto& [start, end] : body.cracks->pieces_of_cut(cut)) {
    const CrackGeometry::Across across = body.cracks->across(cut, (start + end) / 2);
    MovedPiece moved{start, end, {}};
    for (const JumpId jump : across.right) moved.jumps.emplace_back(jump, 1);
    for (const JumpId jump : across.left) moved.jumps.emplace_back(jump, -1);
    pieces.push_back(std::move(moved));
  }
  return Along(body, line, pieces).rows();
}

}  // namespace dda
