#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "models/material/material.hpp"
#include "support/sample.hpp"

namespace dda {
namespace {

class MaterialContract : public testing::TestWithParam<std::string> {
 protected:
  const SchemaBase& schema() const { return *materials().find(GetParam())->schema; }
  std::unique_ptr<Material> make(const Node& parameters, Plane plane) const {
    return materials().choose(GetParam(), parameters).make(plane);
  }
  static double smallest_eigenvalue(const Mat3& c) {
    return Eigen::SelfAdjointEigenSolver<Mat3>(c, Eigen::EigenvaluesOnly).eigenvalues()(0);
  }
  Random random_{21};
};

TEST_P(MaterialContract, StiffnessIsSymmetricPositiveDefinite) {
  for (int i = 0; i < 50; ++i) {
    const Node parameters = sample(schema(), random_);
    for (const Plane plane : {Plane::stress, Plane::strain}) {
      const auto material = make(parameters, plane);
      const Mat3 c = material->stiffness();
      EXPECT_LT((c - c.transpose()).norm(), 1e-14 * c.norm());
      EXPECT_GT(smallest_eigenvalue(c), 0);
      EXPECT_GT(material->modulus(), 0);
    }
  }
}

TEST_P(MaterialContract, PlaneStrainStoresAtLeastTheEnergyOfPlaneStress) {
  for (int i = 0; i < 50; ++i) {
    const Node parameters = sample(schema(), random_);
    const Mat3 stress = make(parameters, Plane::stress)->stiffness();
    EXPECT_GT(smallest_eigenvalue(make(parameters, Plane::strain)->stiffness() - stress),
              -1e-12 * stress.norm());
  }
}

TEST_P(MaterialContract, ParametersInOtherUnitsGiveTheSameMaterial) {
  const UnitChange units{1e-3, 0.025};
  const double stress = units.factor(dimension::stress);
  for (int i = 0; i < 20; ++i) {
    const Node parameters = sample(schema(), random_);
    const auto material = make(parameters, Plane::strain);
    const auto same = make(rescaled(parameters, schema(), units), Plane::strain);
    EXPECT_LT((same->stiffness() / stress - material->stiffness()).norm(),
              1e-12 * material->stiffness().norm());
    EXPECT_NEAR(same->modulus() / stress / material->modulus(), 1, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, MaterialContract, testing::ValuesIn(names_of(materials())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
