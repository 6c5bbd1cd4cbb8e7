#pragma once

#include <fmt/format.h>

#include <string>

#include "meshing/cracks/crack_geometry.hpp"
#include "support/structure.hpp"

namespace dda {

/// Cracks with the law of the regions' own interface.
inline CrackParameters cracks_through(std::vector<std::string> regions, double stiffness) {
  CrackParameters out;
  out.through_blocks = std::move(regions);
  out.begin.resize(3);
  out.stiffness = stiffness;
  return out;
}

/// A structure of one region `body` whose blocks may be cut, held so softly that nothing but itself resists.
class CutStructure {
 public:
  struct Wish {
    std::string subdivision = "{type: voronoi, blocks: 60}";
    double alpha = 0.6;
    double stiffness = 100;     ///< of cuts
    std::string more = "";      ///< of the deck
    std::string of_joint = "";  ///< beside its law
    std::string supports = "{soft: {at: [0, 0], fix: xy}, side: {at: [0, 10], fix: x}}";
    double support_stiffness = 1e-13;
  };
  explicit CutStructure(const Wish& wish)
      : whole_(deck_of(wish)), cracks_(whole_.assembly()), deck_(whole_.deck()), body_(whole_.body()) {
    deck_.cracks.push_back(cracks_through({"body"}, wish.stiffness));
    body_.cracks = &cracks_;
  }
  CutStructure(const CutStructure&) = delete;
  CutStructure& operator=(const CutStructure&) = delete;

  CrackGeometry& cracks() { return cracks_; }
  const Body& body() const { return body_; }
  const ModelDeck& deck() const { return deck_; }
  const Assembly& assembly() const { return whole_.assembly(); }
  Equilibrium equilibrium() const { return Equilibrium(body_, deck_); }

  /// Cuts block after block along a straight line, at most so many; the number of cuts.
  int cut_straight(Vec2 tip, const Vec2& direction, int most = 1000) {
    for (int n = 0;; ++n) {
      const auto block = n < most ? cracks_.block_ahead(tip, direction) : std::nullopt;
      const auto exit = block ? cracks_.exit(*block, tip, direction) : std::nullopt;
      if (!exit || !cracks_.cut(*block, tip, *exit, 0)) return n;
      tip = *exit;
    }
  }
  /// Unknowns of u(x) = G x, cuts closed.
  std::vector<double> field(const Mat2& g) const {
    std::vector<double> d = whole_.field({0, 0}, g);
    d.resize(6 * body_.num_nodes(), 0.0);
    return d;
  }
  /// Forces of uniform tractions σn on the whole boundary.
  StageLoads tractions(const Mat2& stress) const {
    StageLoads out;
    out.force.assign(6 * body_.num_nodes(), 0.0);
    for (std::size_t s = 0; s < assembly().boundary.size(); ++s)
      for (const BoundaryPiece& piece : cracks_.pieces_of_boundary(s)) {
        const Vec2 edge = piece.end - piece.start, n(edge.y(), -edge.x());
        for (const double xi : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
          add_point_force(out, body_, assembly().boundary[s].block,
                          {piece.start + xi * edge, body_.thickness / 2 * stress * n});
      }
    return out;
  }

 private:
  static std::string deck_of(const Wish& wish) {
    return "scene:\n"
           "  regions: [{name: body, material: stone, vertices: [[0, 0], [30, 0], [30, 10], [0, 10]]}]\n"
           "  boundaries: {right: [[30, 0], [30, 10]]}\n"
           "  subdivision: " +
           wish.subdivision +
           "\nthickness: 0.7\n"
           "materials: {stone: {type: linear_elastic, young_modulus: 2, poisson_ratio: 0.2}}\n"
           "interfaces:\n"
           "  joint: {between: [stone, stone], treatment: {type: consistent, alpha: " +
           std::to_string(wish.alpha) +
           "}, law: {type: linear_softening, tensile_strength: 0.01, fracture_energy: 0.01}" + wish.of_joint +
           "}\n"
           "weak_springs: 0\nsupport_stiffness: " +
           fmt::format("{}", wish.support_stiffness) + "\nsupports: " + wish.supports + "\n" + wish.more +
           (wish.more.find("stages:") == std::string::npos
                ? "stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]\n"
                : "");
  }

  Structure whole_;
  CrackGeometry cracks_;
  ModelDeck deck_;
  Body body_;
};

}  // namespace dda
