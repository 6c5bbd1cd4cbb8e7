#include "models/interface/linear_joint.hpp"

namespace dda {
namespace {

struct BondedParameters {};

/// Never released: t = P q with P = k diag(1, 1).
class Bonded final : public LinearJoint {};

Schema<BondedParameters> schema() {
  return Schema<BondedParameters>("A bond that never releases: sub-blocks of one body.");
}

std::unique_ptr<InterfaceLaw> make(const BondedParameters&) { return std::make_unique<Bonded>(); }

}  // namespace

DDA_REGISTER(interface_laws(), "bonded", schema(), make);

}  // namespace dda
