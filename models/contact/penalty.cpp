#include "models/contact/contact_law.hpp"

namespace dda {
namespace {

/// A linear spring, ψ(δ) = ½ k δ². Cores may meet where forces are large for k.
class PenaltyContact final : public ContactLaw {
 public:
  explicit PenaltyContact(const NoParameters&) {}
  ContactResponse respond(double overlap, double k, double) const override {
    return {k / 2 * overlap * overlap, k * overlap, k};
  }
};

}  // namespace

DDA_REGISTER(contact_laws(), "penalty",
             Schema<NoParameters>("A linear spring; bodies hit too hard for it stop the run."),
             make_of<PenaltyContact>);

}  // namespace dda
