#pragma once

#include <limits>

#include "models/interface/law.hpp"

namespace dda {

/// A joint that never cracks, t = D0 q: everything but its stiffness.
class LinearJoint : public InterfaceLaw {
 public:
  bool can_crack() const final { return false; }
  double initial_kappa(double) const final { return std::numeric_limits<double>::infinity(); }
  double rupture_kappa(double) const final { return std::numeric_limits<double>::infinity(); }
  double equivalent_opening(const Vec2& q, const History&, double) const final { return q.norm(); }
  Vec2 opening_gradient(const Vec2& q, const History&, double) const final {
    return q.squaredNorm() > 0 ? Vec2(q.normalized()) : Vec2(Vec2::Zero());
  }
  Response respond(const Vec2& q, const History&, double k) const final {
    const Vec2 d = intact_stiffness(k);
    return {d.cwiseProduct(q), d.asDiagonal()};
  }
  Response respond_frozen(const Vec2& q, const History& h, double k) const final { return respond(q, h, k); }
  Spending spending(const Vec2&, const History&, double) const final { return {}; }
  History accept(const Vec2&, const History& h, double) const final { return h; }
  double stored(const Vec2& q, const History&, double k) const final {
    return 0.5 * q.dot(intact_stiffness(k).cwiseProduct(q));
  }
  double damage(const History&, double) const final { return 0; }
};

}  // namespace dda
