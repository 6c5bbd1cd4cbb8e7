#include "models/interface/linear_joint.hpp"

namespace dda {
namespace {

struct ElasticParameters {
  double normal_stiffness = 0;
  double shear_stiffness = 0;
};

/// A thin elastic layer: physical opening w = (t_n/K_n, t_s/K_s), in series with the trial spring.
///
///     t = D0 q,   D0 = diag(1/(1/k + 1/K_n), 1/(1/k + 1/K_s))
class Elastic final : public LinearJoint {
 public:
  explicit Elastic(const ElasticParameters& p) : layer_(p.normal_stiffness, p.shear_stiffness) {}

  Vec2 intact_stiffness(double k) const override {
    return (layer_.cwiseInverse() + Vec2::Constant(1 / k)).cwiseInverse();
  }

 private:
  Vec2 layer_;
};

Schema<ElasticParameters> schema() {
  using P = ElasticParameters;
  return Schema<P>("A joint of finite stiffness that never cracks: a thin elastic layer.")
      .number("normal_stiffness", &P::normal_stiffness,
              {.dimension = dimension::interface_stiffness,
               .bounds = above(0),
               .text = "Normal traction per opening."})
      .number("shear_stiffness", &P::shear_stiffness,
              {.dimension = dimension::interface_stiffness,
               .bounds = above(0),
               .text = "Shear traction per sliding displacement."});
}

}  // namespace

DDA_REGISTER(interface_laws(), "elastic", schema(), make_of<Elastic>);

}  // namespace dda
