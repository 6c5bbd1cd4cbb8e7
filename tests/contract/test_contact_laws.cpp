// What every law of bodies that meet keeps.
#include <gmock/gmock.h>

#include "models/contact/contact_law.hpp"

namespace dda {
namespace {

class ContactLawContract : public testing::TestWithParam<std::string> {
 protected:
  std::shared_ptr<const ContactLaw> law() const {
    return contact_laws().choose(parse_yaml(GetParam(), "test")).make();
  }
};

constexpr double k = 3e6, reach = 2e-3;

TEST_P(ContactLawContract, ForceAndStiffnessAreDerivatives) {
  for (const double share : {0.01, 0.3, 0.7, 0.95}) {
    const double overlap = share * reach, h = 1e-6 * reach;
    const ContactResponse here = law()->respond(overlap, k, reach),
                          more = law()->respond(overlap + h, k, reach),
                          less = law()->respond(overlap - h, k, reach);
    EXPECT_NEAR((more.energy - less.energy) / (2 * h) / here.force, 1, 1e-6);
    EXPECT_NEAR((more.force - less.force) / (2 * h) / here.stiffness, 1, 1e-6);
  }
}

TEST_P(ContactLawContract, PushesApartMoreAndMore) {
  double before = 0;
  for (double share = 0.01; share < 0.99; share += 0.01) {
    const ContactResponse here = law()->respond(share * reach, k, reach);
    EXPECT_GT(here.force, before);
    EXPECT_GT(here.stiffness, 0);
    before = here.force;
  }
  const double nothing = law()->respond(1e-9 * reach, k, reach).force;
  EXPECT_LT(nothing, 1e-8 * before);
}

TEST_P(ContactLawContract, IsAsStiffInAnyUnitOfLength) {
  constexpr double unit = 1000;
  const ContactResponse here = law()->respond(0.4 * reach, k, reach),
                        other = law()->respond(0.4 * reach * unit, k / unit, reach * unit);
  EXPECT_NEAR(other.force / here.force, 1, 1e-13);
  EXPECT_NEAR(other.energy / (unit * here.energy), 1, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Registry, ContactLawContract, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const FamilyMember* member : contact_laws().entries())
                             names.push_back(member->name);
                           return names;
                         }()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace dda
