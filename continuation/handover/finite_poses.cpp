#include "continuation/handover/finite_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "continuation/motion/energy/positive_factor.hpp"
#include "continuation/motion/energy/potential.hpp"
#include "framework/deck/document/node.hpp"

namespace dda {
namespace {

/// t = k q.
const InterfaceLaw& spring() {
  static const std::shared_ptr<const InterfaceLaw> law =
      interface_laws().choose(Node::scalar("bonded")).make();
  return *law;
}

/// c = X0 + (u0, v0), F = I + r0 skew + ε: places as the path has them.
Pose linear_pose(const Vec2& centroid, const Vec6& d) {
  const Mat2 f = (Mat2() << 1 + d[3], d[5] / 2 - d[2], d[5] / 2 + d[2], 1 + d[4]).finished();
  return pose_of(centroid + d.head<2>(), f);
}

/// A bond that is free of force where the path has left it, with the stiffness that it has there; of none where it bears
/// nothing. `finite` are poses of the same strains.
Bond as_spring(const Bond& bond, const Poses& path, const Poses& finite) {
  const Mat2 local =
      (Mat2() << bond.normal.x(), bond.normal.y(), -bond.normal.y(), bond.normal.x()).finished();
  const Vec2 jump = local *
                    (place_of(path[bond.second], bond.at_second) - place_of(path[bond.first], bond.at_first)),
             stress = state_of(bond, local, finite).stress,
             opening = jump + stress.cwiseQuotient(bond.trial_stiffness()) + bond.multiplier;
  Bond out = bond;
  out.stiffness = secant_of(bond, opening).diagonal().maxCoeff();
  out.law = &spring();
  out.history = {};
  out.multiplier = -jump;
  out.stress_first.setZero();
  out.stress_second.setZero();
  out.initial_stress.setZero();
  return out;
}

/// Bodies, joints and loads of which the least energy is sought.
struct Model {
  MovingScene scene;
  std::vector<Bond> bonds;
};

/// The structure, free of force where it is as the path has left it.
Model at_ease(const Pieces& pieces, const PathEnd& end, const Handover& from) {
  Model out{from.scene, {}};
  Poses path;
  for (std::size_t b = 0; b < out.scene.num_bodies(); ++b) {
    const Vec6 d = pieces.displacements(b, end.state.d.all());
    AffineBlock& block = out.scene.bodies[b].block;
    block.initial_stress = -block.stiffness * d.tail<3>();
    path.push_back(linear_pose(out.scene.bodies[b].centroid, d));
  }
  out.scene.forces.clear();
  for (MotionSpring& spring : out.scene.springs) spring.length += spring.stretch(path);
  for (const std::vector<Bond>* bonds : {&from.bonds, &from.touching})
    for (const Bond& bond : *bonds)
      if (Bond spring = as_spring(bond, path, from.poses); spring.stiffness > 0)
        out.bonds.push_back(std::move(spring));
  return out;
}

/// E/(ρ h²) of the slowest body that moves [1/T²].
double slowest(const MovingScene& scene) {
  double out = std::numeric_limits<double>::infinity();
  for (const MovingBody& body : scene.bodies)
    if (!body.is_held)
      out = std::min(out, body.modulus * body.block.volume / (body.size * body.size * body.block.mass));
  return out;
}

/// Newton's method for the least Π(y) + ½ c |y − y₀|²_M, with steps that are halved until it falls. Nothing meets or rubs here,
/// as in a step (StepMinimum), and where nothing acts there are no forces by which to say that it has been found.
class LeastEnergy {
 public:
  LeastEnergy(const Model& model, double per_square_time)
      : model_(model),
        search_(model.scene, {}),
        potential_(model.scene, search_, model.bonds),
        per_square_time_(per_square_time) {
    potential_.leave_out_meetings();
    potential_.set_histories(Potential::Histories::frozen);
  }

  Poses from(Poses at) {
    constexpr int most = 30;
    constexpr double hardly =
        1e-10;  // of what is stored: the last step of Newton's method is exact beyond rounding
    origin_ = at;
    if (potential_.num_moving() == 0) return at;
    for (int i = 0; i < most; ++i) {
      potential_.begin(at);
      const std::optional<Eigen::VectorXd> way = direction(at);
      if (!way) break;
      if (decrement_ <= hardly * std::abs(potential_.stored(at).sum())) return moved(at, 1, *way);
      const auto next = less(at, *way);
      if (!next) break;
      at = *next;
    }
    return at;
  }

 private:
  Pose held_back(const Poses& at, std::size_t body) const {
    return per_square_time_ * model_.scene.bodies[body].block.times_mass(at[body] - origin_[body]);
  }

  double energy(const Poses& at) const {
    double out = potential_.stored(at).sum();
    for (std::size_t b = 0; b < at.size(); ++b) {
      const Pose way = at[b] - origin_[b];
      if (!model_.scene.forces.empty()) out -= model_.scene.forces[b].dot(way);
      out += held_back(at, b).dot(way) / 2;
    }
    return out;
  }

  /// Newton's direction, of which `decrement_` is what it is to let off.
  std::optional<Eigen::VectorXd> direction(const Poses& at) {
    const Potential::Curvature k =
        potential_.curvature(at, per_square_time_, Potential::Softening::secant, {});
    if (k.has_new_pattern || !is_analysed_) factor_.analyse(k.matrix);
    is_analysed_ = true;
    if (!factor_.factorise(k.matrix)) return {};
    const Eigen::VectorXd gradient = potential_.gradient(at);
    Eigen::VectorXd right(6 * potential_.num_moving());
    for (std::size_t b = 0; b < at.size(); ++b)
      if (const int row = potential_.row_of(b); row >= 0)
        right.segment<6>(6 * row) = -of_body(gradient, b) - held_back(at, b);
    Eigen::VectorXd out = factor_.solve(right);
    decrement_ = right.dot(out) / 2;
    return out;
  }

  Poses moved(Poses at, double share, const Eigen::VectorXd& way) const {
    for (std::size_t b = 0; b < at.size(); ++b)
      if (const int row = potential_.row_of(b); row >= 0) at[b] += share * way.segment<6>(6 * row);
    return at;
  }

  /// A place along a way where there is less; none where that is not found.
  std::optional<Poses> less(const Poses& at, const Eigen::VectorXd& way) const {
    constexpr double shortest = 1e-3;
    const double here = energy(at);
    for (double share = 1; share > shortest; share /= 2)
      if (Poses to = moved(at, share, way); energy(to) < here) return to;
    return {};
  }

  const Model& model_;
  MeetingSearch search_;
  Potential potential_;
  double per_square_time_;
  PositiveFactor factor_;
  bool is_analysed_ = false;
  double decrement_ = 0;
  Poses origin_;
};

constexpr double freely = 1e-9;  // of E/(ρ h²): what nothing joins stays

/// Blocks that were bent are not any more, and what bends are their joints. First what is stiff settles, as between the ends of
/// blocks, by which the shape hardly changes; then all, where loads have not fallen and so hold an equilibrium: it is as near as
/// the path has gone.
Poses lowered(const PathEnd& end, const Handover& from) {
  constexpr double stiff = 1e-3;
  Model model{from.scene, from.bonds};
  model.bonds.insert(model.bonds.end(), from.touching.begin(), from.touching.end());
  model.scene.gravity.setZero();
  Poses undeformed;
  for (const MovingBody& body : model.scene.bodies) undeformed.push_back(body.undeformed());
  const double c = slowest(model.scene);
  const Poses settled = LeastEnergy(model, stiff * c).from(from.poses);
  if (end.has_fallen) return settled;
  Poses out = LeastEnergy(model, freely * c).from(settled);
  return farthest(settled, out) <= farthest(undeformed, settled) ? out : settled;
}

}  // namespace

Poses finite_poses(const Pieces& pieces, const PathEnd& end, const Handover& from) {
  if (pieces.are_lowered()) return lowered(end, from);
  const Model model = at_ease(pieces, end, from);
  return LeastEnergy(model, freely * slowest(model.scene)).from(from.poses);
}

}  // namespace dda
