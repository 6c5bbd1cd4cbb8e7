#include "contract/law_contract.hpp"

namespace dda {
namespace {

class ScaledLaws : public LawContract {};

/// A scaled law is the law of the scaled parameters, at the stiffness of the point.
TEST_P(ScaledLaws, AreTheLawsOfScaledParameters) {
  for (int c = 0; c < cases; ++c) {
    const LawCase mean = random_law(GetParam(), random_, c % 2 == 0);
    const double a = random_.between(0.5, 1.5), b = random_.between(0.7, 1.3);
    const auto law = interface_laws().choose(GetParam(), scaled_parameters(mean.parameters, a, b)).make();
    const LawCase at = scaled({interface_laws().choose(GetParam(), mean.parameters).make(), mean.parameters,
                               mean.k, mean.first, mean.last},
                              a, b);
    EXPECT_NEAR(at.law->initial_kappa(at.k), law->initial_kappa(at.k), 1e-14 * at.first);
    EXPECT_NEAR(at.law->steepest_slope(), law->steepest_slope(), 1e-12 * at.k);
    History h, other;
    for (int i = 0; i < draws; ++i) {
      const Vec2 q = at.admissible(random_opening(at), h);
      const Response found = at.law->respond(q, h, at.k), wanted = law->respond(q, other, at.k);
      EXPECT_LT((found.traction - wanted.traction).norm(), 1e-9 * at.stiff() * at.last) << at.text();
      h = at.law->accept(q, h, at.k);
      other = law->accept(q, other, at.k);
      EXPECT_NEAR(h.dissipated, other.dissipated, 1e-9 * (h.dissipated + at.k * at.first * at.first));
      EXPECT_NEAR(at.law->stored(q, h, at.k), law->stored(q, other, at.k),
                  1e-9 * at.stiff() * at.last * at.last);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, ScaledLaws,
                         testing::Values("linear_softening", "bilinear_softening", "exponential_softening",
                                         "mohr_coulomb"),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
