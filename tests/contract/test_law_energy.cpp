#include "contract/law_contract.hpp"

namespace dda {
namespace {

/// What a point has done along a programme of openings.
struct Ledger {
  double work = 0;       ///< ∫ t·dq, Simpson's rule in each substep
  double stored = 0;     ///< ψ at the end
  double spent = 0;      ///< by the law's own books
  double supplied = 0;   ///< by water
  double least = 0;      ///< smallest energy spent in one substep
  double tolerance = 0;  ///< Σ stiff |dq|² of a substep per leg, the size of what one kink can cost

  double imbalance() const { return std::abs(work + supplied - stored - spent); }
};

/// Corners of a programme: tension, compression, sliding back and forth, contact again.
std::vector<Vec2> random_corners(const LawCase& at, Random& random, int legs) {
  std::vector<Vec2> out{Vec2::Zero()};
  for (int leg = 0; leg < legs; ++leg) {
    Vec2 next = random.point(1.3 * (random.coin() ? at.last : 2 * at.first));
    if (leg % 4 == 2) next.x() = -std::abs(next.x());
    if (leg % 4 == 3) next = {out.back().x(), -next.y()};
    out.push_back(next);
  }
  return out;
}

/// Follows straight lines between the corners; what fails at once is released where it stands.
class Programme {
 public:
  explicit Programme(const LawCase& at) : at_(at) {}

  Ledger follow(const std::vector<Vec2>& corners, int substeps) {
    for (std::size_t leg = 1; leg < corners.size(); ++leg) {
      const Vec2 step = (corners[leg] - corners[leg - 1]) / substeps;
      for (int i = 0; i < substeps; ++i)
        substep(corners[leg - 1] + i * step, corners[leg - 1] + (i + 1) * step);
      out_.tolerance += at_.stiff() * step.squaredNorm();
    }
    out_.stored = at_.law->stored(corners.back(), h_, at_.k);
    out_.spent = h_.dissipated;
    out_.supplied = at_.law->supplied(h_);
    return out_;
  }

 private:
  void substep(const Vec2& from, const Vec2& to) {
    const Vec2 sum = at_.traction(from, h_) + 4 * at_.traction(0.5 * (from + to), h_) + at_.traction(to, h_);
    out_.work += sum.dot(to - from) / 6;
    const double before = h_.dissipated;
    h_ = at_.law->accept(to, h_, at_.k);
    out_.least = std::min(out_.least, h_.dissipated - before);
    if (at_.must_release(to, h_)) h_ = at_.released(to, h_, 0);
  }

  const LawCase& at_;
  History h_;
  Ledger out_;
};

class LawEnergy : public LawContract {
 protected:
  static constexpr int programmes = 30, legs = 8;
};

/// Work = stored + spent, at second order of the substep: a kink inside a substep costs some stiff |dq|².
TEST_P(LawEnergy, WorkIsStoredOrSpent) {
  double coarse = 0, fine = 0, scale = 0;
  for (int i = 0; i < programmes; ++i) {
    const LawCase at = next_case();
    const std::vector<Vec2> corners = random_corners(at, random_, legs);
    const Ledger few = Programme(at).follow(corners, 250), many = Programme(at).follow(corners, 1000);
    coarse += few.imbalance() / (at.stiff() * at.last * at.last);
    fine += many.imbalance() / (at.stiff() * at.last * at.last);
    scale += 1;
    EXPECT_LT(many.imbalance(), 3 * many.tolerance) << i << "\n" << at.text();
  }
  EXPECT_TRUE(fine < 1e-12 * scale || coarse / fine > 8) << coarse / scale << " to " << fine / scale;
}

TEST_P(LawEnergy, NothingIsEverGained) {
  for (int i = 0; i < programmes; ++i) {
    const LawCase at = next_case();
    const Ledger found = Programme(at).follow(random_corners(at, random_, legs), 1000);
    EXPECT_GE(found.least, -1e-12 * at.stiff() * at.last * at.last) << at.text();
  }
}

TEST_P(LawEnergy, ClosedCyclesGiveNoEnergy) {
  for (int i = 0; i < programmes; ++i) {
    const LawCase at = next_case();
    std::vector<Vec2> corners = random_corners(at, random_, 4);
    const std::vector<Vec2> once(corners.begin() + 1, corners.end());
    corners.push_back(Vec2::Zero());
    double before = 0;
    for (int cycle = 0; cycle < 3; ++cycle) {
      const Ledger found = Programme(at).follow(corners, 500);
      EXPECT_GE(found.work + found.supplied, before - 3 * found.tolerance) << "cycle " << cycle << "\n"
                                                                           << at.text();
      before = found.work + found.supplied;
      corners.insert(corners.end(), once.begin(), once.end());
      corners.push_back(Vec2::Zero());
    }
  }
}

/// ∫ t · dq from 0 to q over `corner` by the midpoint rule, damage growing or not.
double loading_work(const LawCase& at, const Vec2& corner, const Vec2& q) {
  constexpr int steps = 4000;
  double work = 0;
  for (const auto& [from, to] : {std::pair(Vec2(0, 0), corner), std::pair(corner, q)})
    for (int i = 0; i < steps; ++i)
      work += at.traction(from + (i + 0.5) / steps * (to - from), {}).dot(to - from) / steps;
  return work;
}

TEST_P(LawEnergy, WorkOfLoadingIsThatOfAPotential) {
  for (int c = 0; c < cases; ++c) {
    const LawCase at = next_case();
    if (!at.has_potential()) continue;
    for (int i = 0; i < 5; ++i) {
      const Vec2 q = random_.point(at.last);
      const double scale = at.stiff() * q.squaredNorm(), straight = loading_work(at, q / 2, q);
      EXPECT_NEAR(loading_work(at, {q.x(), 0}, q), straight, 1e-6 * scale);
      EXPECT_NEAR(loading_work(at, {0, q.y()}, q), straight, 1e-6 * scale);
    }
  }
}

/// A history in other units: what the law remembers has the dimension that the law declares.
History rescaled(const InterfaceLaw& law, History h, const UnitChange& units) {
  h.dissipated *= units.factor(dimension::energy_per_area);
  for (const Remembered& one : law.memory())
    for (double& number : remembered(law, h, one.name)) number *= units.factor(one.dimension);
  return h;
}

TEST_P(LawEnergy, ParametersInOtherUnitsGiveTheSameLaw) {
  const UnitChange units{1e-3, 0.025};
  const double stress = units.factor(dimension::stress);
  for (int c = 0; c < cases; ++c) {
    Random repeated = random_;
    const LawCase at = random_law(GetParam(), random_, c % 2 == 0);
    const LawCase other = random_law(GetParam(), repeated, c % 2 == 0, units);
    EXPECT_NEAR(other.k, at.k * units.factor(dimension::interface_stiffness), 1e-12 * other.k);
    for (int i = 0; i < draws; ++i) {
      const Vec2 q = random_opening(at);
      const History h = at.reachable(random_), same = rescaled(*at.law, h, units);
      const double force = stress * at.stiff() * at.last, energy = force * units.length * at.last;
      EXPECT_LT((other.traction(units.length * q, same) - stress * at.traction(q, h)).norm(), 1e-10 * force);
      EXPECT_NEAR(other.law->spending(units.length * q, same, other.k).value,
                  units.factor(dimension::energy_per_area) * at.law->spending(q, h, at.k).value,
                  1e-10 * energy);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, LawEnergy, testing::ValuesIn(names_of(interface_laws())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
