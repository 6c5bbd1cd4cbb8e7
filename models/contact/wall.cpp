#include <cmath>

#include "models/contact/contact_law.hpp"

namespace dda {
namespace {

/// A spring that becomes a wall:
///
///     ψ(δ) = −½ k (2s)² ln(1 − δ²/(2s)²)        ½ k δ² where δ ≪ 2s
class Wall final : public ContactLaw {
 public:
  explicit Wall(const NoParameters&) {}
  ContactResponse respond(double overlap, double k, double reach) const override {
    const double share = overlap / reach, left = 1 - share * share;
    return {-k / 2 * reach * reach * std::log(left), k * overlap / left,
            k * (1 + share * share) / (left * left)};
  }
};

}  // namespace

DDA_REGISTER(contact_laws(), "wall",
             Schema<NoParameters>(
                 "A spring that stiffens without bounds: small overlaps cost ½ k δ², and cores never meet."),
             make_of<Wall>);

}  // namespace dda
