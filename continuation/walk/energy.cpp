#include "continuation/walk/energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dda {
namespace {

/// Values and rates of one scalar at both ends of a step, ξ from 0 to 1.
struct Ends {
  double from, to, rate_from, rate_to;

  double value(double x) const {
    const double y = 1 - x;
    return from * y * y * (1 + 2 * x) + to * x * x * (1 + 2 * y) + rate_from * x * y * y -
           rate_to * x * x * y;
  }
  double rate(double x) const {
    return 6 * x * (1 - x) * (to - from) + rate_from * (1 - x) * (1 - 3 * x) + rate_to * x * (3 * x - 2);
  }
};

/// ∫ F u' dξ with three Gauss points: exact, the integrand has degree five.
double integral(const Ends& force, const Ends& displacement) {
  const double half = std::sqrt(0.6) / 2;
  constexpr std::array weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  const std::array places{0.5 - half, 0.5, 0.5 + half};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += weights[i] * force.value(places[i]) * displacement.rate(places[i]);
  return sum;
}

/// A gauge over a step; without tangents its rates are those of the chord, which gives the trapezoid.
Ends ends_of(const Functional& gauge, const Stretch& step) {
  const double from = step.from.value(gauge), to = step.to.value(gauge);
  if (step.length == 0) return {from, to, to - from, to - from};
  return {from, to, step.length * step.leaving.rate(gauge), step.length * step.arriving.rate(gauge)};
}

}  // namespace

Functional displacement_of_load(const Loading& loading, std::size_t num_blocks) {
  Functional out;
  double forces = 0;
  for (std::size_t i = 0; i + block_unknowns <= loading.reference_work.size(); i += block_unknowns)
    if (const Eigen::Map<const Vec6> row(loading.reference_work.data() + i); !row.isZero(0)) {
      out.rows.emplace_back(BlockId{i / block_unknowns}, row);
      if (out.rows.back().first.value() < num_blocks) forces += row.head<2>().norm();
    }
  if (loading.load_is_force && forces > 0)
    for (auto& [block, row] : out.rows) row /= forces;
  for (const WorkPair& pair : loading.driven) out.add(1, pair.displacement);
  return out;
}

namespace {

/// Whether the rates at the ends of a step tell of the way between. Where bodies that only touch move as a mechanism, the
/// little that is spent beside tells nothing of how far they go.
bool is_told(const Ends& way) {
  constexpr double most = 10;
  return std::max(std::abs(way.rate_from), std::abs(way.rate_to)) <= most * std::abs(way.to - way.from);
}

}  // namespace

double external_work(const System& system, const Stretch& whole) {
  const Loading& loading = system.loading();
  Stretch step = whole;
  if (system.joins_by_contact() && !is_told(ends_of(system.reference_work(), step))) step.length = 0;
  const State &from = step.from, &to = step.to;
  const Ends load = ends_of(Functional{.rows = {}, .per_load_factor = 1}, step);
  const Ends displacement = ends_of(system.reference_work(), step);
  double work = integral(load, displacement) + system.dead_work(to) - system.dead_work(from);
  for (const WorkPair& pair : loading.driven)
    work += integral(ends_of(pair.force, step), ends_of(pair.displacement, step));
  if (!loading.reference_offset.empty()) {
    const auto power = [&](const State& state) {
      const LawValues laws = system.laws(state);
      double sum = 0;
      for (std::size_t p = 0; p < laws.traction.size(); ++p)
        sum += system.equilibrium().point(p).weight * laws.traction[p].dot(loading.reference_opening(p));
      return sum;
    };
    work += 0.5 * (power(from) + power(to)) * (to.load_factor - from.load_factor);
  }
  return work;
}

}  // namespace dda
