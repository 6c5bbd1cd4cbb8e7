#include <Eigen/LU>
#include <cmath>

#include "continuation/integrator/integrator.hpp"

namespace dda {
namespace {

enum class Rotation { exact, first_order };

struct ClassicParameters : OpenCloseRules {
  Rotation rotation = Rotation::exact;
  double velocity_kept = 1;
};

/// What a way of a body is in first order about where it is: z = (u, D F), D = [εx, γ/2 − r; γ/2 + r, εy].
struct Displacement {
  Vec2 way;
  Mat2 gradient;  ///< D
};

double turn_of(const Mat2& gradient) { return (gradient(1, 0) - gradient(0, 1)) / 2; }

/// Discontinuous deformation analysis as it was published: constant acceleration over a step, whose unknowns
/// d = (u0, v0, r0, εx, εy, γxy) are those of first-order blocks about where they are.
///
///     d = dt κ ḋ₀ + ½ dt² d̈,   ḋ₁ = κ ḋ₀ + dt d̈        so that  (2/dt²) M (d − dt κ ḋ₀) + ∇Π = 0
///
/// κ is the share of its velocity with which a body begins a step: 1 is dynamics, 0 goes from rest to rest. Rates ḋ turn
/// and strain with nothing; F₁ = (I + D) F of `first_order` grows with every rotation, by √(1 + r²), and no stress knows
/// of it; F₁ = R(r) (I + ε) F of `exact` does not. In all six numbers of a pose the way of such a step is z = (u, D F).
///
/// Work of a step: K₁ − κ² K₀ = −∇Π · z where K₁ is that of ḋ₁ at F; what K₁ changes from F to F₁ is taken as given.
///
/// Source: Shi (1988), Discontinuous deformation analysis; exact rotation: MacLaughlin and Sitar (1996).
class Classic final : public Integrator {
 public:
  explicit Classic(const ClassicParameters& p) : p_(p) {}

  BodyCourse begin(const Pose& now, const Pose& velocity, double dt) const override {
    return {now - dt * velocity, now, velocity, Pose::Zero()};
  }
  double per_square_time(const Interval& dt) const override { return 2 / (dt.now * dt.now); }
  Pose flight(const AffineBlock&, const BodyCourse& at, const Interval& dt) const override {
    return at.now + p_.velocity_kept * dt.now * at.velocity;
  }
  BodyCourse arrive(const BodyStep& step) const override {
    const BodyCourse& at = step.start;
    const Displacement d = displaced(at.now, step.reached), rate = rates(at.now, rate_after(step));
    const Pose velocity = pose_of(rate.way, rate.gradient * gradient_of(step.reached));
    return {at.now, step.reached, velocity, (velocity - p_.velocity_kept * at.velocity) / step.dt.now,
            at.growth * growth_of(d)};
  }
  BodyWork work(const AffineBlock& block, const BodyStep& step) const override {
    const Pose rate = rate_after(step), there = arrive(step).velocity;
    return {way_of(step), step.reached - step.start.now,
            kinetic_energy(block, p_.velocity_kept * step.start.velocity),
            kinetic_energy(block, there) - kinetic_energy(block, rate)};
  }
  BodyCourse pushed(const BodyCourse& at, const RigidMotion& by, double) const override {
    BodyCourse out = at;
    out.velocity += rate_of(at.now, by);
    return out;
  }
  Pose carried(const Pose& now, const Pose& way) const override {
    if (p_.rotation == Rotation::first_order) return now + way;
    const Mat2 d = rates(now, way).gradient;
    const Mat2 strain = (d + d.transpose()) / 2;
    return pose_of(centre_of(now) + centre_of(way),
                   rotation(turn_of(d)) * (Mat2::Identity() + strain) * gradient_of(now));
  }
  const OpenCloseRules* open_close() const override { return &p_; }
  bool grows() const override { return p_.rotation == Rotation::first_order; }
  bool has_inertia() const override { return p_.velocity_kept > 0; }

 private:
  /// (u, D) of a way in first order.
  static Displacement rates(const Pose& now, const Pose& way) {
    return {centre_of(way), gradient_of(way) * gradient_of(now).inverse()};
  }
  /// (u, D) that has led from one pose to another.
  Displacement displaced(const Pose& now, const Pose& reached) const {
    const Mat2 change = gradient_of(reached) * gradient_of(now).inverse();
    const Vec2 way = centre_of(reached) - centre_of(now);
    if (p_.rotation == Rotation::first_order) return {way, change - Mat2::Identity()};
    const Polar polar = polar_of(change);
    Mat2 turn;
    turn << 0, -polar.angle, polar.angle, 0;
    return {way, turn + polar.stretch - Mat2::Identity()};
  }
  Pose way_of(const BodyStep& step) const {
    const Displacement d = displaced(step.start.now, step.reached);
    return pose_of(d.way, d.gradient * gradient_of(step.start.now));
  }
  /// ḋ₁, as a rate at the pose where the step begins.
  Pose rate_after(const BodyStep& step) const {
    return 2 / step.dt.now * way_of(step) - p_.velocity_kept * step.start.velocity;
  }
  double growth_of(const Displacement& d) const {
    return p_.rotation == Rotation::first_order ? std::hypot(1.0, turn_of(d.gradient)) : 1.0;
  }

  ClassicParameters p_;
};

Schema<ClassicParameters> schema() {
  using P = ClassicParameters;
  return Schema<P>(
             "Discontinuous deformation analysis as Shi has it, for comparison: constant acceleration, "
             "penalties, open-close iteration. Bodies overlap, and how they rebound hangs on the step.")
      .number("penalty", &P::penalty,
              {.fallback = 10,
               .bounds = between(1e-2, 1e4),
               .text = "Stiffness of a contact along its normal, in E · thickness, instead of what "
                       "`motion.contact` says: how far bodies overlap."})
      .number("shear_share", &P::shear_share,
              {.fallback = 0.4,
               .bounds = between(1e-3, 10),
               .text = "Stiffness along the edge over that along the normal, as long as a contact sticks."})
      .number("displacement", &P::displacement,
              {.fallback = 0.01,
               .bounds = between(1e-4, 0.5),
               .text = "The farthest that a corner may go in a step, over the size of the smallest block; "
                       "contacts are sought within 2.5 times that."})
      .integer(
          "most_passes", &P::most_passes,
          {.fallback = 6,
           .bounds = between(1, 100),
           .text = "Linear systems of a step in which contacts may still open, close or slip; then it is "
                   "cut to 0.3 of its length."})
      .number(
          "velocity_kept", &P::velocity_kept,
          {.fallback = 1,
           .bounds = between(0, 1),
           .text = "Share of its velocity with which a body begins a step: 1 is dynamics, less is damped, "
                   "0 goes from rest to rest."})
      .one_of("rotation", &P::rotation, {{"exact", Rotation::exact}, {"first_order", Rotation::first_order}},
              {.fallback = Rotation::exact,
               .text = "How blocks turn in a step; `first_order`, as published, makes them grow, and is for "
                       "blocks that nothing joins."});
}

}  // namespace

DDA_REGISTER(integrators(), "classic", schema(), make_of<Classic>);

}  // namespace dda
