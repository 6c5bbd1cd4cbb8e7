#pragma once

#include <memory>

#include "continuation/integrator/open_close.hpp"
#include "framework/deck/family.hpp"
#include "models/kinematics/affine.hpp"

namespace dda {

/// Three instants of a motion: a step dt behind the last one, dt₋.
struct Interval {
  double now = 0;       ///< dt [T]
  double before = 0;    ///< dt₋ [T]
  bool begins = false;  ///< the motion, with a velocity that is that of now and no mean over dt₋
};

/// How a body has come to where it is.
struct BodyCourse {
  Pose before, now;                  ///< dt₋ ago, and now
  Pose velocity = Pose::Zero();      ///< ẏ, as the integrator means it [1/T]
  Pose acceleration = Pose::Zero();  ///< ÿ, as the last step has found it [1/T²]
  double growth = 1;                 ///< of lengths, by rotations in first order: no strain
  RigidMotion steady = {};  ///< the acceleration that lasts: without vibrations and impacts [L/T², 1/T²]
  Pose lag = Pose::Zero();  ///< how far behind `now` the place is up to which its loads have worked
};

/// What bodies that hold together do as one in a step: means by mass, zero where one of them is held.
struct AsOne {
  Vec2 pull = Vec2::Zero();                        ///< acceleration by the loads [L/T²]
  Vec2 before = Vec2::Zero(), now = Vec2::Zero();  ///< accelerations of the last step and of this one
  Vec2 way = Vec2::Zero();                         ///< [L]
};

/// A step of a body: from where it is, past where inertia would take it, to where it has come.
struct BodyStep {
  const BodyCourse& start;
  Pose flight;   ///< ŷ
  Pose reached;  ///< y₁
  Interval dt;
  AsOne as_one = {};       ///< with what it holds together with
  double gyration = 1;     ///< radius of [L]
  bool is_joined = false;  ///< by bonds, which are stiff
  double lasts = 0;        ///< the share of the last step's forces on it that is still there
};

/// What a step has done to a body: K₁ − K̂ = −∇Π(y₁) · way + of_start.
struct BodyWork {
  Pose way;             ///< along which the forces at the end count
  Pose rubbed;          ///< along which friction has worked, and what drives a body
  double flown = 0;     ///< K̂ [F L]
  double of_start = 0;  ///< by the forces at the start, or taken by what resists every motion [F L]
};

/// How damping by a M acts in a step: by the velocity s (y₁ − y₀)/dt − (s − 1) ẏ₀, for so long.
struct DampedFlight {
  double rate = 1;  ///< s
  double span = 0;  ///< between the instants of ẏ₀ and ẏ₁ [T]
};

/// How bodies go from one instant to the next: to the minimum of
///
///     ½ c |y − ŷ|²_M + Π(y)        so that  M c (y₁ − ŷ) + ∇Π(y₁) = 0
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// A course that begins at a pose with a velocity ẏ, as if a step dt had led there.
  virtual BodyCourse begin(const Pose& now, const Pose& velocity, double dt) const = 0;
  /// c [1/T²].
  virtual double per_square_time(const Interval& dt) const = 0;
  /// ŷ.
  virtual Pose flight(const AffineBlock& block, const BodyCourse& at, const Interval& dt) const = 0;
  /// Whether ẏ is a mean over the last step: kinetic energy is that of its middle then.
  virtual bool has_mean_velocities() const { return false; }
  /// The share of the forces at the end of a step, those at its start having the rest, in the work of what is driven.
  virtual double share_of_end() const { return 1; }
  /// s of the velocity at the end of a step: ẏ₁ = s (y₁ − y₀)/dt − (s − 1) ẏ₀.
  virtual double end_rate() const { return 1; }
  /// Of what nothing but a constant force and a M act on.
  virtual DampedFlight damped_flight(double /*a*/, const Interval& dt) const { return {end_rate(), dt.now}; }
  /// The course with y₁ as its now.
  virtual BodyCourse arrive(const BodyStep& step) const = 0;
  virtual BodyWork work(const AffineBlock& block, const BodyStep& step) const = 0;
  /// The same course with a rigid motion more; dt was its last step.
  virtual BodyCourse pushed(const BodyCourse& at, const RigidMotion& by, double dt) const = 0;
  /// The same course as that of a rigid body: with its momentum and its angular momentum, without rates of strain; dt was its
  /// last step.
  virtual BodyCourse calmed(const AffineBlock& block, const BodyCourse& at, double dt) const {
    return pushed(begin(at.now, Pose::Zero(), dt), rigid_motion_of(block, at.now, at.velocity), dt);
  }
  /// Where a way z in first order leads from a pose.
  virtual Pose carried(const Pose& now, const Pose& way) const { return now + way; }
  /// Set where a step is no minimum: bodies meet by springs that open and close, and all else is in first order.
  virtual const OpenCloseRules* open_close() const { return nullptr; }
  /// Whether rotations let bodies grow.
  virtual bool grows() const { return false; }
  /// Whether what moves has inertia; else it goes where forces send it as long as they do.
  virtual bool has_inertia() const { return true; }
};

/// ½ |v|²_M.
double kinetic_energy(const AffineBlock& block, const Pose& velocity);

using IntegratorFamily = Family<Integrator>;
using IntegratorChoice = Choice<Integrator>;

/// The registry of integrators.
IntegratorFamily& integrators();

}  // namespace dda
