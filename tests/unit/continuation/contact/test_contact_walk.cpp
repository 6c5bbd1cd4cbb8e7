// Contact and friction on random small structures, solved from piece to piece.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "continuation/contact/contact_walk.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// q = q0 − G z under a prescribed load factor 1, G of a structure with as many free bodies as `loose` says:
/// S = P − P G P has as many zero eigenvalues.
ContactProblem random_problem(Random& random, int points, double coefficient, int loose = 0) {
  const Eigen::Index n = 2 * points;
  Matrix q(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) q(i, j) = random.between(-1, 1);
  const Matrix basis = q.householderQr().householderQ();
  Vector share(n);
  for (Eigen::Index i = 0; i < n; ++i) share[i] = i < loose ? 1 : random.between(0.05, 0.95);
  ContactProblem out;
  out.couplings = Matrix::Zero(n + 1, n);
  out.couplings.topRows(n) = basis * share.asDiagonal() * basis.transpose();
  out.live = Vector::Zero(n);
  out.control = Vector::Unit(n + 1, n);
  out.constant = Vector::Zero(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) out.constant[i] = -random.between(-1, 1);
  out.constant[n] = -1;
  out.accuracy = 1e-12;
  for (int i = 0; i < points; ++i)
    out.points.push_back({.weight = 1,
                          .trial = {1, 1},
                          .base = Mat2::Identity(),
                          .contact = Contact{.closed = 1, .friction = 1, .coefficient = coefficient}});
  return out;
}

/// |F| with the tractions that contact and Coulomb's law give at q, the worst component.
double missed(const ContactProblem& problem, const Vector& x) {
  Vector z(x.size() - 1);
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const Vec2 q = x.segment<2>(2 * static_cast<Eigen::Index>(i));
    const ContactProblem::Point& point = problem.points[i];
    const Response now = response_on(*point.contact, piece_at(*point.contact, q, false), q);
    z.segment<2>(2 * static_cast<Eigen::Index>(i)) = now.traction - point.base * q;
  }
  Vector f = x + problem.constant + problem.couplings * z;
  f.head(x.size() - 1) -= x[x.size() - 1] * problem.live;
  f[x.size() - 1] = problem.control.dot(x) + problem.constant[x.size() - 1];
  return f.lpNorm<Eigen::Infinity>();
}

TEST(ContactWalk, SolvesFromAnywhereForAnyFriction) {
  Random random(5);
  for (const double coefficient : {0.0, 0.1, 0.5, 1.0, 3.0})
    for (int i = 0; i < 20; ++i) {
      const ContactProblem problem = random_problem(random, 12, coefficient);
      Vector start = 0.5 * Vector::Ones(problem.constant.size());
      for (double& value : start) value *= random.between(-1, 1);
      ContactMatrix matrix;
      const auto found = walk_from(problem, start, matrix), covered = walk_covered(problem, matrix);
      ASSERT_TRUE(covered) << coefficient << " " << i;
      EXPECT_LT(missed(problem, *covered), 1e-11);
      if (found) {
        EXPECT_LT(missed(problem, *found), 1e-11);
      }
      EXPECT_TRUE(found || coefficient > 0.1);
    }
}

/// Where strong friction leads walks from nearby round in loops, viscous motion comes to rest.
TEST(ContactWalk, MovesToRestWhereItWouldGoRoundInLoops) {
  Random random(8);
  int lost = 0;
  for (int i = 0; i < 60; ++i) {
    const ContactProblem problem = random_problem(random, 40, 5);
    Vector start = Vector::Ones(problem.constant.size());
    for (double& value : start) value *= random.between(-1, 1);
    ContactMatrix matrix;
    if (walk_from(problem, start, matrix)) continue;
    ++lost;
    const auto found = walk_proximally(problem, start, matrix);
    ASSERT_TRUE(found) << i;
    EXPECT_LT(missed(problem, *found), 1e-10);
  }
  EXPECT_GT(lost, 0);
}

/// What somebody does not want to wait for finds nothing, wherever on its way it is told so.
TEST(ContactWalk, IsGivenUpWhenAsked) {
  Random random(8);
  const ContactProblem problem = random_problem(random, 40, 5);
  const Vector start = Vector::Ones(problem.constant.size());
  const auto corners = [&](const std::function<bool()>& is_over) {
    ContactMatrix matrix;
    const bool found = walk_covered(problem, matrix, {.is_over = is_over}).has_value();
    return std::pair(found, matrix.num_changes());
  };
  const auto [found, all] = corners({});
  ASSERT_TRUE(found);
  for (const int patience : {0, 5}) {
    int asked = 0;
    const auto [is_found, passed] = corners([&] { return ++asked > patience; });
    EXPECT_FALSE(is_found);
    EXPECT_LT(passed, all);
    ContactMatrix matrix;
    asked = 0;
    EXPECT_FALSE(walk_proximally(problem, start, matrix, {.is_over = [&] { return ++asked > patience; }}));
  }
}

/// Pressed points that all stand at their limits of friction, and a body that moves off freely at the load factor 1:
/// the way by which its gap shall open is prescribed, and nothing else moves.
struct Mechanism {
  ContactProblem problem;
  Vector before, after;  ///< where it stands, and where it has moved by 1
};
Mechanism mechanism(Random& random, int pressed) {
  const Eigen::Index last = 2 * pressed, n = last + 2;
  Mechanism out{random_problem(random, pressed + 1, 3), Vector::Zero(n + 1), {}};
  ContactProblem& problem = out.problem;
  problem.couplings.topRows(last) =
      random_problem(random, pressed, 3).couplings.topRows(last) * Matrix::Identity(last, n);
  problem.couplings.bottomRows(3).setZero();
  problem.couplings(last, last) = 1;
  problem.couplings(last + 1, last + 1) = 0.5;
  for (int i = 0; i < pressed; ++i) {
    const double pressure = random.between(0.5, 1);
    out.before.segment<2>(2 * i) << -pressure, (random.coin() ? 3 : -3) * pressure;
    problem.points[static_cast<std::size_t>(i)].slides = true;
  }
  out.before[last] = 1;
  out.before[n] = 1;
  out.after = out.before;
  out.after[last] = 2;
  for (Eigen::Index i = 0; i < last; ++i) problem.live[i] = random.between(-1, 1);
  problem.live[last] = 1;
  problem.constant << problem.live - out.before.head(n), -2;
  problem.constant[last] = 1;
  problem.control = Vector::Unit(n + 1, last);
  return out;
}

/// The residual stiffness bears a little that joints at their limits cannot bear: without it there is nothing.
TEST(ContactWalk, MovesAMechanismWhoseJointsStandAtTheirLimits) {
  Random random(10);
  for (int i = 0; i < 40; ++i) {
    const Mechanism m = mechanism(random, 12);
    EXPECT_LT(missed(m.problem, m.after), 1e-12);
    ContactMatrix matrix;
    const auto found = walk_from(m.problem, m.before, matrix);
    ASSERT_TRUE(found) << i;
    EXPECT_LT(missed(m.problem, *found), 1e-10) << i;
    EXPECT_NEAR((*found)[m.after.size() - 1], 1, 1e-9) << i;
  }
}

/// A matrix that is moved by few changes solves like one that is factorised.
TEST(ContactMatrix, MovesByChangesOfRankOne) {
  Random random(9);
  const ContactProblem problem = random_problem(random, 200, 1);
  std::vector<Mat2> changes(200, Mat2::Zero());
  for (std::size_t i = 0; i < 120; ++i) changes[i] = -Mat2::Identity() * random.between(0, 1);
  ContactMatrix moved, anew;
  ASSERT_TRUE(moved.move_to(problem, changes));
  changes[3] = Mat2::Zero();
  changes[150] << -0.5, 0, 0.3, -0.7;
  ASSERT_TRUE(moved.move_to(problem, changes));
  ASSERT_TRUE(anew.factor(problem, changes));
  Vector b = problem.constant;
  for (double& value : b) value += random.between(-1, 1);
  EXPECT_LT((moved.solve(b) - anew.solve(b)).norm(), 1e-10 * b.norm());
  EXPECT_EQ(moved.num_factorisations(), 1);
}

/// One point with S = [[1, −c], [−c, 1]]: more than one solution from μ = 1/c on; one of them is found.
TEST(ContactWalk, FindsOneOfSeveralSolutions) {
  Random random(6);
  for (int i = 0; i < 40; ++i) {
    ContactProblem problem = random_problem(random, 1, 3);
    const double c = 0.6;
    problem.couplings.topRows(2) = Mat2::Identity() - 0.5 * (Mat2() << 1, -c, -c, 1).finished();
    ContactMatrix matrix;
    const auto found = walk_covered(problem, matrix);
    ASSERT_TRUE(found);
    EXPECT_LT(missed(problem, *found), 1e-11);
  }
}

TEST(ContactWalk, FindsNothingWhereABodyFliesAway) {
  ContactProblem problem;
  problem.couplings = Matrix::Zero(3, 2);
  problem.couplings.topRows(2).setIdentity();  // nothing but the contact holds the body
  problem.live = Vector::Zero(2);
  problem.control = Vector::Unit(3, 2);
  problem.constant = Vector::Zero(3);
  problem.constant[0] = -1;  // pulled off
  problem.constant[2] = -1;
  problem.accuracy = 1e-12;
  problem.points.push_back({.weight = 1,
                            .trial = {1, 1},
                            .base = Mat2::Identity(),
                            .contact = Contact{.closed = 1, .friction = 1, .coefficient = 0.5}});
  ContactMatrix matrix;
  const auto found = walk_covered(problem, matrix);
  EXPECT_TRUE(!found || missed(problem, *found) > 1e-3);
}

TEST(ContactPieces, MeetAtTheirEnds) {
  Random random(7);
  const Contact contact{
      .closed = 3, .open = 0.4, .shear = 0.2, .friction = 2, .coefficient = 0.7, .slip = 0.1};
  for (int i = 0; i < 300; ++i) {
    const Vec2 q = random.point(1), along = random.point(1);
    const ContactPiece piece = piece_at(contact, q, false);
    const auto end = end_of_piece(contact, piece, q, along);
    if (!end) continue;
    const Vec2 there = q + end->length * along;
    const Response here = response_on(contact, piece, there), behind = response_on(contact, end->to, there);
    EXPECT_LT((here.traction - behind.traction).norm(), 1e-12);
    const PieceChange change = change_between(contact, piece, end->to);
    EXPECT_LT((behind.tangent - here.tangent - change.u * change.v.transpose()).norm(), 1e-14);
    EXPECT_EQ(piece_at(contact, q + 1.000001 * end->length * along + 1e-9 * along, false), end->to);
  }
}

}  // namespace
}  // namespace dda
