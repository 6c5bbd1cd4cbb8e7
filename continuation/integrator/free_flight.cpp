#include <cmath>

#include "continuation/integrator/last_step.hpp"

namespace dda {
namespace {

/// Flies exactly where nothing acts, for any rotation and any step; parabolas are exact at their nodes, contact and
/// strain are implicit.
///
///     ĉ = c + dt w,      F̂ = R(φ + Δφ dt/dt₋ + dt dt_m α) (U + ΔU dt/dt₋)      F = R U,  w and Δ from the last step
///     dt_m = ½ (dt + dt₋), ½ dt at the beginning;   α of `turned_back`
class FreeFlight final : public LastStep {
 public:
  explicit FreeFlight(const NoParameters&) {}
  double mean(const Interval& dt) const override { return dt.begins ? dt.now / 2 : dt.now; }
  Pose flight(const AffineBlock& block, const BodyCourse& at, const Interval& dt) const override {
    const double share = dt.now / dt.before;
    const Polar then = polar_of(gradient_of(at.before)), here = polar_of(gradient_of(at.now));
    const double turn = share * std::remainder(here.angle - then.angle, 2 * M_PI);
    const double back = dt.now * mean(dt) * turned_back(block, at.now, turn);
    const RigidMotion more = made_up(at, dt);
    return pose_of(centre_of(at.now) + share * (centre_of(at.now) - centre_of(at.before)) + more.velocity,
                   rotation(here.angle + turn + back + more.spin) *
                       (here.stretch + share * (here.stretch - then.stretch)));
  }
  Vec2 curvature(const BodyStep& step) const override {
    const AsOne& of = step.as_one;
    const double most = 3 * of.pull.norm();
    return {common(of.before.x(), of.now.x(), most), common(of.before.y(), of.now.y(), most)};
  }
  /// By the loads and by what of the reactions to them lasts, which are no more than twice as large: not by stiff vibrations
  /// and impacts, which a step that is implicit in them has used up by its end.
  RigidMotion lasting(const BodyStep& step, const Pose& acceleration) const override {
    const AsOne& of = step.as_one;
    const double most = 2 * of.pull.norm();
    const Vec2 one = of.before - of.pull, other = of.now - of.pull;
    RigidMotion out{of.pull + Vec2(common(one.x(), other.x(), most), common(one.y(), other.y(), most)), 0};
    if (!step.is_joined)
      out.spin = common(rigid_part(step.start.now, step.start.acceleration).spin,
                        rigid_part(step.reached, acceleration).spin, most / step.gyration);
    return out;
  }

 private:
  /// Where the lasting acceleration takes a body in what the last step was longer than this one: [L, 1].
  static RigidMotion made_up(const BodyCourse& at, const Interval& dt) {
    if (dt.begins) return {};
    const double factor = dt.now * (dt.before - dt.now) / 2;
    return {factor * at.steady.velocity, factor * at.steady.spin};
  }
};

}  // namespace

DDA_REGISTER(
    integrators(), "free_flight",
    Schema<NoParameters>("Exact in free flight, rotations included; implicit in contact and strain, whose "
                         "vibrations it damps."),
    make_of<FreeFlight>);

}  // namespace dda
