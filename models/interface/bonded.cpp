#include "models/interface/linear_joint.hpp"

namespace dda {
namespace {

/// Never released: t = P q with P = k diag(1, 1).
class Bonded final : public LinearJoint {};

Schema<NoParameters> schema() {
  return Schema<NoParameters>("A bond that never releases: sub-blocks of one body.");
}

}  // namespace

DDA_REGISTER(interface_laws(), "bonded", schema(), make_of<Bonded>);

}  // namespace dda
