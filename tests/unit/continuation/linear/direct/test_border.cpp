// A base whose structure gets more cuts, against one that is factorised with all of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "continuation/linear/linear_system.hpp"
#include "support/cut_structure.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

constexpr double same = 1e-10;

CutStructure::Wish held() {
  return {.subdivision = "{type: voronoi, blocks: 80, seed: 3}", .support_stiffness = 1};
}

/// What has grown, or been taken back, where the first cuts are what they were.
Growth growth_of(const Equilibrium& before, const Equilibrium& now, std::size_t same_cuts,
                 std::size_t same_jumps) {
  Growth out{.nodes = {}, .points = {}, .same_cuts = same_cuts, .keeps_stiffness = true};
  for (std::size_t n = 0; n < now.num_nodes(); ++n)
    out.nodes.push_back(n < now.num_blocks() + same_jumps ? std::optional(n) : std::nullopt);
  const std::size_t same_points = std::min(before.num_active(), now.num_active()) -
                                  2 * (std::min(before.num_cuts(), now.num_cuts()) - same_cuts);
  for (std::size_t p = 0; p < now.num_active(); ++p)
    out.points.push_back(p < same_points ? std::optional(p) : std::nullopt);
  return out;
}

/// A structure with some cuts, whose linear system follows further ones.
class Following {
 public:
  explicit Following(const std::string& solver)
      : structure_(held()), solver_(direct_solvers().choose(solver)) {
    cut({8, 0}, {0.1, 1}, 2);
    equilibrium_.emplace(structure_.equilibrium());
    linear_.emplace(*equilibrium_, solver_, LinearSystem::Update::low_rank);
    linear_->begin_stage(equilibrium_->stages()[0]);
  }

  /// Some blocks along a line.
  void cut(Vec2 tip, const Vec2& direction, int most) { structure_.cut_straight(tip, direction, most); }
  void drop(int cuts) {
    for (int i = 0; i < cuts; ++i) structure_.cracks().drop_last();
  }
  void follow(std::size_t same_cuts) {
    const Equilibrium before = *equilibrium_;
    linear_->let_go();
    ASSERT_TRUE(equilibrium_->remake(structure_.body(), structure_.deck()));
    linear_->follow(growth_of(before, *equilibrium_, same_cuts, same_cuts));
    linear_->begin_stage(equilibrium_->stages()[0]);
  }
  /// Points that have softened, unloaded, and slide.
  std::vector<Mat2> tangents() const {
    std::vector<Mat2> out;
    for (std::size_t p = 0; p < equilibrium_->num_active(); ++p) {
      out.emplace_back(equilibrium_->point(p).intact_stiffness().asDiagonal());
      if (p % 3 == 0) out.back() *= 1e-4;
      if (p % 3 == 1) out.back() *= -1e-6;
    }
    return out;
  }
  std::vector<std::size_t> all_points() const {
    std::vector<std::size_t> out(equilibrium_->num_active());
    std::iota(out.begin(), out.end(), std::size_t{0});
    return out;
  }

  CutStructure structure_;
  DirectSolverChoice solver_;
  std::optional<Equilibrium> equilibrium_;
  std::optional<LinearSystem> linear_;
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return most / size;
}

class BorderTest : public testing::TestWithParam<std::string> {
 protected:
  /// Solutions, columns, couplings, kept solutions and inertia are those of a system that is factorised anew.
  void expect_as_factorised(Following& of) {
    LinearSystem fresh(*of.equilibrium_, of.solver_, LinearSystem::Update::refactorise);
    LinearSystem updated(*of.equilibrium_, of.solver_, LinearSystem::Update::low_rank);
    for (LinearSystem* linear : {&fresh, &updated}) linear->begin_stage(of.equilibrium_->stages()[0]);
    const std::vector<Mat2> tangents = of.tangents();
    for (LinearSystem* linear : {&*of.linear_, &fresh, &updated}) ASSERT_TRUE(linear->set_tangent(tangents));
    Random random(7);
    const std::vector<double> b = random.vector(of.equilibrium_->num_unknowns(), 1);
    std::vector<double> x(b.size()), wanted(b.size());
    of.linear_->solve(b, x);
    fresh.solve(b, wanted);
    EXPECT_LT(distance(x, wanted), same);
    EXPECT_LT(distance(of.linear_->reference_direction().all(), fresh.reference_direction().all()), same);
    std::vector<LinearSystem::Hinge> hinges;
    for (const std::size_t p : of.all_points()) hinges.push_back({p, Vec2(1, 0.5), Vec2(0.5, 1)});
    const auto found = of.linear_->flexibility(hinges), known = updated.flexibility(hinges);
    ASSERT_TRUE(found && known);
    EXPECT_LT((*found - *known).norm(), same * known->norm());
    EXPECT_EQ(of.linear_->negative_eigenvalues().of_stiffness, fresh.negative_eigenvalues().of_stiffness);
    expect_same_columns(*of.linear_, updated, of.all_points());
  }

  /// Z s of all points.
  static void expect_same_columns(LinearSystem& grown, LinearSystem& fresh,
                                  const std::vector<std::size_t>& points) {
    fresh.add_points(points);
    grown.add_points(points);
    Random random(11);
    const std::vector<double> s = random.vector(2 * points.size(), 1);
    const Eigen::MatrixXd shares = Eigen::Map<const Eigen::VectorXd>(s.data(), std::ssize(s));
    std::vector<double> z(fresh.reference_solution().size()), wanted(z.size());
    const std::span<double> of_grown(z), of_fresh(wanted);
    grown.subtract_columns(points, shares, {&of_grown, 1});
    fresh.subtract_columns(points, shares, {&of_fresh, 1});
    EXPECT_LT(distance(z, wanted), same);
  }
};

TEST_P(BorderTest, GrowsWithItsCuts) {
  Following of(GetParam());
  expect_as_factorised(of);
  const std::size_t factorisations = of.linear_->num_factorisations();
  of.cut(of.structure_.cracks().cuts().back().end, {0.1, 1}, 2);
  of.follow(2);
  expect_as_factorised(of);
  of.cut({20, 0}, {-0.2, 1}, 3);
  of.follow(4);
  expect_as_factorised(of);
  EXPECT_EQ(of.linear_->num_factorisations(), factorisations);
  EXPECT_EQ(of.linear_->grown(), (std::vector<std::size_t>{2, 4, 7}));
}

TEST_P(BorderTest, LosesTheLastCutsAgain) {
  Following of(GetParam());
  of.cut(of.structure_.cracks().cuts().back().end, {0.1, 1}, 2);
  of.follow(2);
  const Vec2 tip = of.structure_.cracks().cuts().back().end;
  of.cut(tip, {0.1, 1}, 2);
  of.follow(4);
  expect_as_factorised(of);
  of.drop(2);
  of.cut(tip, {0.6, 1}, 1);
  of.follow(4);
  expect_as_factorised(of);
  EXPECT_EQ(of.linear_->grown(), (std::vector<std::size_t>{2, 4, 5}));
  EXPECT_EQ(of.linear_->num_factorisations(), 1u);
}

/// A cut of the base itself is taken back.
TEST_P(BorderTest, FactorisesWhereTheBaseLosesACut) {
  Following of(GetParam());
  of.drop(1);
  of.follow(1);
  expect_as_factorised(of);
  EXPECT_EQ(of.linear_->num_factorisations(), 2u);
}

/// Whatever was there before: the same bits follow from the base, its growths and the points in their order.
TEST_P(BorderTest, LeavesNoTraceOfWhatWasTakenBack) {
  Following one(GetParam()), other(GetParam());
  const Vec2 tip = one.structure_.cracks().cuts().back().end;
  one.linear_->add_points(one.all_points());
  one.cut(tip, {0.1, 1}, 2);
  one.follow(2);
  one.linear_->add_points(one.all_points());
  one.drop(2);
  for (Following* of : {&one, &other}) {
    of->cut(tip, {0.6, 1}, 1);
    of->follow(2);
    of->linear_->add_points(of->all_points());
  }
  const auto n = 2 * static_cast<Eigen::Index>(one.all_points().size());
  EXPECT_EQ(one.linear_->couplings().topLeftCorner(n, n), other.linear_->couplings().topLeftCorner(n, n));
  EXPECT_EQ(one.linear_->reference_solution(), other.linear_->reference_solution());
}

INSTANTIATE_TEST_SUITE_P(Solvers, BorderTest, testing::Values("cholmod", "mumps"));

}  // namespace
}  // namespace dda
