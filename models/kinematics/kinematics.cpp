#include "models/kinematics/kinematics.hpp"

#include <algorithm>

namespace dda {
namespace {

struct FirstOrderParameters {};

/// Blocks of constant strain: those of the paper.
class FirstOrder final : public Kinematics {
 public:
  explicit FirstOrder(const FirstOrderParameters&) {}
  bool is_second_order(const std::string&) const override { return false; }
};

struct SecondOrderParameters {
  std::vector<std::string> regions;
};

/// Blocks of linear strain, everywhere or in some regions.
class SecondOrder final : public Kinematics {
 public:
  explicit SecondOrder(SecondOrderParameters p) : p_(std::move(p)) {}
  bool is_second_order(const std::string& region) const override {
    return p_.regions.empty() || std::ranges::find(p_.regions, region) != p_.regions.end();
  }
  std::vector<std::string> regions() const override { return p_.regions; }

 private:
  SecondOrderParameters p_;
};

Schema<FirstOrderParameters> first_order_schema() {
  return Schema<FirstOrderParameters>(
      "Blocks of constant strain, six unknowns each: enough where cracks may run between any two blocks, "
      "whose size they set.");
}

Schema<SecondOrderParameters> second_order_schema() {
  using P = SecondOrderParameters;
  return Schema<P>(
             "Blocks of linear strain, twelve unknowns each: the same error with a tenth of the unknowns "
             "where "
             "cracks keep to named interfaces, in bending, and for nearly incompressible materials.")
      .texts("regions", &P::regions,
             {.fallback = std::vector<std::string>{},
              .text = "Names of the regions whose blocks are of second order; all when empty. Blocks of both "
                      "orders may "
                      "be neighbours."});
}

}  // namespace

DDA_REGISTER(kinematics(), "first_order", first_order_schema(), make_of<FirstOrder>);
DDA_REGISTER(kinematics(), "second_order", second_order_schema(), make_of<SecondOrder>);

}  // namespace dda
