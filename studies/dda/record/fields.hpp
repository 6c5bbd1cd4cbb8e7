#pragma once

#include <map>
#include <span>
#include <string>

#include "continuation/state/system.hpp"
#include "framework/deck/units.hpp"
#include "framework/files/run/results.hpp"
#include "models/body/body.hpp"
#include "models/parameters.hpp"

namespace dda {

/// What one stored step looks like, and in which history it was reached.
struct StoredState {
  int step = 0;
  State state;
  std::vector<History> history;
  std::vector<std::vector<double>> modes = {};  ///< shapes φ, where they were computed
};

/// Of the regions, by number; where the material of one is called otherwise it stands behind in brackets.
std::vector<std::string> region_names(const Assembly& assembly);

/// Turns a state into the fields that a run stores.
///
///     blocks     displacement (vertices), strain ε, stress C ε + σ0(λ), of blocks of second order the means of both, and
///                the gradient of ε and σ at the vertices; principal stresses in the plane
///                σ_1, σ_2 = (σ_xx + σ_yy)/2 ± √(((σ_xx − σ_yy)/2)² + σ_xy²)
///     modes      φ_1, φ_2, … as displacements (vertices), the largest of each 1
///     parts      of blocks that cracks have cut: displacement (vertices), modes, strain and stresses of their block
///     points     jump g = [u] (n, s),  opening w = q − P⁻¹ t,  traction t,  damage,
///                the strength's factor where some interface has a random field
///
/// Interface points are the active ones (they can crack, or iterate a multiplier); each owns an equal piece
/// of its side, a segment of the mesh, or of a cut, a piece of a crack. A vertex of a cut block moves with the part
/// at which it lies.
class Fields {
 public:
  Fields(const Body& body, const ModelParameters& model, const Equilibrium& equilibrium, const Units& units);

  ResultsMesh mesh() const;
  Snapshot snapshot(const StoredState& at) const;

  /// The interface at a state, all of size num_active().
  struct Interface {
    std::vector<Vec2> opening, jump, traction;
    std::vector<double> damage;
  };
  Interface interface_at(const StoredState& at) const;
  /// Ends of the piece of side, or of cut, that point p owns [L].
  std::array<Vec2, 2> segment(std::size_t p) const;
  /// Mean displacement of both faces of a point's segment at x [L].
  Vec2 displacement_between(std::size_t p, const Vec2& x, std::span<const double> d) const;
  /// A vertex of an outline, and its displacement [L].
  struct MovedVertex {
    Vec2 x, u;
  };
  /// Outlines of a block, or of the parts that cuts leave of it.
  std::vector<std::vector<MovedVertex>> moved_parts(BlockId block, std::span<const double> d) const;
  /// Outline of a block as it is stored and drawn: of a block of second order, whose sides bend, with their middles.
  std::vector<Vec2> outline(BlockId block) const;
  const Body& body() const { return body_; }
  const Equilibrium& equilibrium() const { return equilibrium_; }

 private:
  std::vector<Vec2> drawn(BlockId block, const Polygon& outline) const;
  /// Displacement of a block at x, as far as cuts leave it whole [L].
  Vec2 displacement(BlockId block, const Vec2& x, std::span<const double> d) const;
  /// Of what lies behind a point: its second block, or on a plane of symmetry the image of the first.
  Vec2 displacement_behind(const InterfacePoint& point, const Vec2& x, std::span<const double> d) const;
  Vec2 displacement_by(std::span<const JumpId> jumps, const Vec2& x, std::span<const double> d) const;
  void add_motion(const std::string& name, const std::string& unit, std::span<const double> d,
                  Snapshot& out) const;
  void add_gradients(const State& state, Snapshot& out) const;
  /// Means over the blocks.
  struct BlockFields {
    StoredField strain, stress;
    StoredField out_of_plane;  ///< σz in plane strain, εz in plane stress
  };
  BlockFields block_fields(const State& state) const;
  void add_stress_at_vertices(const BlockFields& means, const State& state, Snapshot& out) const;
  void add_blocks(const State& state, Snapshot& out) const;
  /// Active points, from the first to before the last.
  struct Points {
    std::size_t begin, end;
    FieldPlace place, place_of_ends;
  };
  void add_points(const Interface& all, const Points& points, const StoredState& at, Snapshot& out) const;
  std::vector<double> mode(const std::vector<double>& shape) const;
  CutBlocks cut_blocks() const;
  std::map<std::string, double> load_factors(double now) const;

  const Body& body_;
  const ModelParameters& model_;
  const Equilibrium& equilibrium_;
  Units units_;
  std::vector<std::array<Vec2, 2>> segments_;
};

}  // namespace dda
