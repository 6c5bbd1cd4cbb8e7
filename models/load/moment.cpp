#include "models/body/place_schema.hpp"
#include "models/body/rotation.hpp"
#include "models/load/load.hpp"

namespace dda {
namespace {

struct MomentParameters : Place {
  double moment = 0;
  Position where;
};

/// A couple, counter-clockwise, dual to the rotation of its place: f += M ∂θ/∂d. On blocks at a point it acts on their
/// rotations r0, in equal parts; over a patch it is a traction that grows linearly from the middle,
/// t = 12 M s/(L³ thickness) n, without a resultant.
class Moment final : public Load {
 public:
  explicit Moment(MomentParameters p) : p_(std::move(p)) {}
  void add_to(StageLoads& stage, const Body& body) const override {
    rotation_at(body, p_, p_.where).add_gradient(p_.moment, stage.force);
  }

 private:
  MomentParameters p_;
};

Schema<MomentParameters> schema() {
  using P = MomentParameters;
  Schema<P> s(
      "A couple on the blocks at a point, or over a patch of the boundary. In a motion its forces keep their "
      "directions: it falls with the cosine of the turn.");
  add_place(s);
  return s.number(
      "moment", &P::moment,
      {.dimension = dimension::moment, .text = "The couple M, counter-clockwise, at load factor 1."});
}

}  // namespace

DDA_REGISTER(loads(), "moment", schema(), make_of<Moment>);

}  // namespace dda
