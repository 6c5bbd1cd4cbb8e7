#include <gtest/gtest.h>

#include <cmath>

#include "models/gauge/gauge.hpp"
#include "models/load/load.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

constexpr UnitChange other_units{1e-3, 0.025};

/// Parameters with every place moved off the structure.
Node moved_away(Node parameters, const SchemaBase& schema) {
  for (const Parameter& p : schema.parameters())
    if (Node* value = parameters.find(p.name);
        value && (p.kind.form == KindInfo::Form::point || p.kind.form == KindInfo::Form::spot) &&
        p.kind.dimension == dimension::length)
      *value = Node::sequence({Node::number(7), Node::number(7)});
  return parameters;
}

/// Parameters with every required text replaced by one that names nothing.
Node misnamed(Node parameters, const SchemaBase& schema) {
  for (const Parameter& p : schema.parameters())
    if (p.is_required() && p.kind.form == KindInfo::Form::text)
      parameters.set(p.name, Node::scalar("no_such_name"));
  return parameters;
}

/// Plane strain, where stresses out of the plane are.
const std::string held = "plane: strain\n";

class LoadContract : public testing::TestWithParam<std::string> {
 protected:
  const SchemaBase& schema() const { return *loads().find(GetParam())->schema; }
  Node next() { return sample(schema(), random_, square_names()); }
  StageLoads of(const Node& parameters, const Structure& on) const {
    StageLoads out = on.no_loads();
    loads().choose(GetParam(), parameters).make()->add_to(out, on.body());
    return out;
  }
  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  const Structure square_{square_deck(held)};
  Random random_{23};
};

TEST_P(LoadContract, DoesSomething) {
  const StageLoads found = of(next(), square_);
  double largest = 0;
  for (const double f : found.force) largest = std::max(largest, std::abs(f));
  EXPECT_TRUE(largest > 0 || !found.driven.empty() || !found.removed.empty());
}

TEST_P(LoadContract, ForceIsDerivativeOfTheEnergyOfItsResultant) {
  // The power under a rigid motion is that of resultant and moment; a moved pole changes the moment by c × F.
  for (int i = 0; i < 20; ++i) {
    const StageLoads found = of(next(), square_);
    Mat2 turn;
    turn << 0, -1, 1, 0;
    const Vec2 resultant(dot(found.force, square_.field({1, 0}, Mat2::Zero())),
                         dot(found.force, square_.field({0, 1}, Mat2::Zero())));
    EXPECT_LE(resultant.norm(), found.resultant * (1 + 1e-12) + 1e-14);
    const Vec2 pole = random_.point(1);
    const double about_origin = dot(found.force, square_.field({0, 0}, turn));
    const double about_pole = dot(found.force, square_.field(-turn * pole, turn));
    EXPECT_NEAR(about_pole, about_origin - cross(pole, resultant), 1e-13 * (1 + found.resultant));
    if (resultant.norm() > 1e-12 && found.resultant > 0) {
      const double arm = std::abs(about_origin) / found.resultant;
      EXPECT_LE(arm, std::sqrt(2.0) * (1 + 1e-12)) << "the line of action passes the unit square";
    }
  }
}

TEST_P(LoadContract, AddsToWhatIsThere) {
  const Node parameters = next();
  const StageLoads once = of(parameters, square_);
  StageLoads twice = once;
  loads().choose(GetParam(), parameters).make()->add_to(twice, square_.body());
  for (std::size_t i = 0; i < once.force.size(); ++i)
    EXPECT_NEAR(twice.force[i], 2 * once.force[i], 1e-14 * (1 + once.resultant));
  EXPECT_DOUBLE_EQ(twice.resultant, 2 * once.resultant);
  EXPECT_EQ(twice.driven.size(), 2 * once.driven.size());
  EXPECT_EQ(twice.removed.size(), 2 * once.removed.size());
  for (std::size_t i = 0; i < once.initial_stress.size(); ++i)
    EXPECT_EQ(twice.initial_stress[i], Vec3(2 * once.initial_stress[i]));
  for (std::size_t i = 0; i < once.out_of_plane.size(); ++i)
    EXPECT_EQ(twice.out_of_plane[i], 2 * once.out_of_plane[i]);
}

TEST_P(LoadContract, ParametersInOtherUnitsGiveTheSameLoad) {
  const Structure other(square_deck(held), other_units);
  const Node parameters = next();
  const StageLoads found = of(parameters, square_);
  const StageLoads same = of(rescaled(parameters, schema(), other_units), other);
  for (std::size_t i = 0; i < found.force.size(); ++i) {
    const double factor = other_units.factor(i % 6 < 2 ? dimension::force : dimension::moment);
    EXPECT_NEAR(same.force[i] / factor, found.force[i], 1e-12 * (1 + found.resultant)) << "unknown " << i;
  }
  EXPECT_NEAR(same.resultant / other_units.force, found.resultant, 1e-12 * (1 + found.resultant));
  ASSERT_EQ(same.driven.size(), found.driven.size());
  for (std::size_t i = 0; i < found.driven.size(); ++i)
    EXPECT_NEAR(same.driven[i].prescribed / other_units.length, found.driven[i].prescribed, 1e-12);
  ASSERT_EQ(same.initial_stress.size(), found.initial_stress.size());
  for (std::size_t i = 0; i < found.initial_stress.size(); ++i)
    EXPECT_LT(
        (same.initial_stress[i] / other_units.factor(dimension::stress) - found.initial_stress[i]).norm(),
        1e-12);
  ASSERT_EQ(same.out_of_plane.size(), found.out_of_plane.size());
  for (std::size_t i = 0; i < found.out_of_plane.size(); ++i)
    EXPECT_NEAR(same.out_of_plane[i] / other_units.factor(dimension::stress), found.out_of_plane[i], 1e-12);
}

TEST_P(LoadContract, PlacesAndNamesThatAreNotThereAreRefused) {
  const Node parameters = next();
  for (const Node& wrong : {moved_away(parameters, schema()), misnamed(parameters, schema())}) {
    if (wrong == parameters) continue;
    if (!of(parameters, square_).removed.empty()) continue;  // supports are known where all stages are made
    EXPECT_THROW(of(wrong, square_), InputError);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, LoadContract, testing::ValuesIn(names_of(loads())),
                         [](const auto& chosen) { return chosen.param; });

class GaugeContract : public testing::TestWithParam<std::string> {
 protected:
  const SchemaBase& schema() const { return *gauges().find(GetParam())->schema; }
  Node next() { return sample(schema(), random_, square_names()); }
  std::unique_ptr<Gauge> make(const Node& parameters) const {
    return gauges().choose(GetParam(), parameters).make();
  }
  static Functional functional(const Gauge& gauge, const Structure& on) {
    const Equilibrium equilibrium = on.equilibrium();
    return gauge.functional({on.body(), equilibrium.stages().back().reactions});
  }
  const Structure square_{square_deck()};
  Random random_{24};
};

TEST_P(GaugeContract, GradientIsDifferenceOfValue) {
  for (int i = 0; i < 10; ++i) {
    const Functional gauge = functional(*make(next()), square_);
    const std::vector<double> d = random_.vector(24, 1), e = random_.vector(24, 1);
    std::vector<double> moved = d, gradient(24, 0.0);
    for (std::size_t k = 0; k < 24; ++k) moved[k] += e[k];
    gauge.add_gradient(1, gradient);
    double predicted = 0.5 * gauge.per_load_factor;
    for (std::size_t k = 0; k < 24; ++k) predicted += gradient[k] * e[k];
    const double scale =
        std::abs(gauge.value(moved, 1.5)) + std::abs(gauge.value(d, 1)) + std::abs(predicted);
    EXPECT_NEAR(gauge.value(moved, 1.5) - gauge.value(d, 1), predicted, 1e-12 * scale);
    EXPECT_GT(scale, 0);
  }
}

TEST_P(GaugeContract, MeasuresWhatItsDimensionSays) {
  const Structure other(square_deck(), other_units);
  for (int i = 0; i < 10; ++i) {
    const Node parameters = next();
    const auto gauge = make(parameters), same = make(rescaled(parameters, schema(), other_units));
    ASSERT_EQ(gauge->dimension(), same->dimension());
    const std::vector<double> d = random_.vector(24, 1);
    const double value = functional(*gauge, square_).value(d, 0.3);
    const double rescaled_value = functional(*same, other).value(rescaled(d, other_units), 0.3);
    EXPECT_NEAR(rescaled_value / other_units.factor(gauge->dimension()) / value, 1, 1e-9);
  }
}

TEST_P(GaugeContract, PlacesAndNamesThatAreNotThereAreRefused) {
  const Node parameters = next();
  for (const Node& wrong : {moved_away(parameters, schema()), misnamed(parameters, schema())}) {
    if (wrong == parameters) continue;
    EXPECT_THROW(functional(*make(wrong), square_), InputError);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, GaugeContract, testing::ValuesIn(names_of(gauges())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
