#pragma once

#include <memory>
#include <string>

#include "framework/deck/family.hpp"
#include "models/body/body.hpp"
#include "models/body/functional.hpp"
#include "models/body/place.hpp"

namespace dda {

/// A stiff spring whose far end the stage moves: paper eqs 16-22.
struct DrivenSpring {
  std::string name;         ///< of its reaction; "" where the deck gives none
  Functional displacement;  ///< l · u of the driven point
  double prescribed = 0;    ///< δ at full stage value [L]
  double share = 1;         ///< of the stiffness p̄ that every driven spring has
  Vec2 direction = Vec2::Zero();
  Position where = {};
  std::size_t spring = 0;  ///< among those of all stages; this and what follows as DrivenSprings has it
  double sense = 1;        ///< −1 where that spring measures the opposite
};

/// A support that is taken away: what it bears when the stage begins acts in its place, and fades.
struct RemovedSupport {
  std::string name;
  Position where;
};

/// What one stage adds at its full value.
struct StageLoads {
  std::vector<double> force;  ///< work-conjugate to d, size 6 · nodes of the body
  /// Its means by block, and behind them its two slopes (eigenstress.hpp) in each block of second order [F/L²]; empty
  /// when there is none.
  std::vector<Vec3> initial_stress;
  /// What it brings out of the plane, in the same places: a stress in plane strain [F/L²], a strain in plane stress.
  std::vector<double> out_of_plane;
  std::vector<DrivenSpring> driven;
  std::vector<RemovedSupport> removed;
  double resultant = 0;  ///< Σ |force| of the single loads [F]
};

/// What acts at one place: where, and along which direction.
struct Action {
  Place place;
  Vec2 along;
};

/// Something that acts on the structure in a stage.
class Load {
 public:
  virtual ~Load() = default;
  /// Adds the load at full value. Throws InputError when its place is not on the body.
  virtual void add_to(StageLoads& stage, const Body& body) const = 0;
  /// Where it acts, if that is one place.
  virtual std::optional<Action> action() const { return {}; }
};

struct PointForce {
  Vec2 x;      ///< [L]
  Vec2 force;  ///< [F]
};

/// Adds the force vector F at point x of a block: f += Tᵀ F, and Jᵀ F of the jumps that move it.
void add_point_force(StageLoads& stage, const Body& body, BlockId id, const PointForce& at);

using LoadFamily = Family<Load>;
using LoadChoice = Choice<Load>;

/// The registry of loads.
LoadFamily& loads();

}  // namespace dda
