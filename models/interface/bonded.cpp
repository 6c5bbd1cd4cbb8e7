#include <limits>

#include "models/interface/law.hpp"

namespace dda {
namespace {

struct BondedParameters {};

/// Never released: t = P q with P = k diag(1, 1).
class Bonded final : public InterfaceLaw {
 public:
  double shear_weight() const override { return 1; }
  double steepest_slope() const override { return 0; }
  bool can_crack() const override { return false; }
  double initial_kappa(double) const override { return std::numeric_limits<double>::infinity(); }
  double rupture_kappa(double) const override { return std::numeric_limits<double>::infinity(); }
  double equivalent_opening(const Vec2& q) const override { return q.norm(); }
  Vec2 opening_gradient(const Vec2& q) const override {
    return q.squaredNorm() > 0 ? Vec2(q.normalized()) : Vec2(Vec2::Zero());
  }
  Response respond(const Vec2& q, const History&, double k) const override {
    return {k * q, k * Mat2::Identity()};
  }
  Response respond_frozen(const Vec2& q, const History& h, double k) const override {
    return respond(q, h, k);
  }
  double dissipation(double, double) const override { return 0; }
  double dissipation_slope(double, double) const override { return 0; }
  double damage(double, double) const override { return 0; }
};

Schema<BondedParameters> schema() {
  return Schema<BondedParameters>("A bond that never releases: sub-blocks of one body.");
}

std::unique_ptr<InterfaceLaw> make(const BondedParameters&) { return std::make_unique<Bonded>(); }

}  // namespace

DDA_REGISTER(interface_laws(), "bonded", schema(), make);

}  // namespace dda
