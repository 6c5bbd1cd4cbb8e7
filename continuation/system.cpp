#include "continuation/system.hpp"

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>

namespace dda {

System::System(const Equilibrium& equilibrium, const DirectSolverChoice& solver, LinearSystem::Update update)
    : equilibrium_(equilibrium),
      loading_(nullptr),
      linear_(equilibrium, solver, update),
      history_(equilibrium.num_crackable()),
      map_(Teuchos::rcp(new TpetraMap(equilibrium.num_unknowns(), 0, Tpetra::getDefaultComm()))) {
  set_stage(0);
}

void System::set_stage(std::size_t stage) {
  loading_ = &equilibrium_.stages()[stage];
  remembered_.laws.reset();
  linear_.keep_solutions_of(loading_->reference, loading_->dead);
}

void System::set_history(std::vector<History> history) {
  history_ = std::move(history);
  remembered_.laws.reset();
}

void System::set_frozen(bool frozen) {
  if (frozen_ != frozen) remembered_.laws.reset();
  frozen_ = frozen;
}

bool System::use_tangent(std::size_t stamp, std::span<const Mat2> tangents) {
  if (stamp == used_stamp_) return true;
  used_stamp_ = linear_.set_tangent(tangents) ? stamp : 0;
  return used_stamp_ != 0;
}

std::shared_ptr<const LawValues> System::laws_at(std::span<const double> d, double load_factor) {
  if (!remembered_.laws || remembered_.at.load_factor != load_factor ||
      !std::ranges::equal(remembered_.at.d, d)) {
    remembered_.laws = std::make_shared<const LawValues>(laws(d, load_factor));
    remembered_.at = {{d.begin(), d.end()}, load_factor};
  }
  return remembered_.laws;
}

LawValues System::laws(std::span<const double> d, double load_factor) const {
  const std::size_t n = equilibrium_.num_crackable();
  LawValues out{std::vector<Vec2>(n), std::vector<Vec2>(n), std::vector<Mat2>(n)};
  equilibrium_.gather(*loading_, d, load_factor, {out.opening.data()->data(), 2 * n});
  for (std::size_t p = 0; p < n; ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const Response response = frozen_
                                  ? point.law->respond_frozen(out.opening[p], history_[p], point.stiffness)
                                  : point.law->respond(out.opening[p], history_[p], point.stiffness);
    out.traction[p] = response.traction;
    out.tangent[p] = response.tangent;
  }
  return out;
}

void System::residual(std::span<const double> d, double load_factor, const LawValues& laws,
                      std::span<double> out) const {
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = -loading_->dead[i] - load_factor * loading_->reference[i];
  equilibrium_.intact().multiply_add(d, out);
  std::vector<Vec2> correction(laws.traction.size());
  for (std::size_t p = 0; p < correction.size(); ++p) {
    const Vec2 stiffness = equilibrium_.point(p).trial_stiffness();
    Vec2 jump = laws.opening[p];
    if (!loading_->dead_offset.empty()) jump -= Eigen::Map<const Vec2>(loading_->dead_offset.data() + 2 * p);
    if (!loading_->reference_offset.empty())
      jump -= load_factor * Eigen::Map<const Vec2>(loading_->reference_offset.data() + 2 * p);
    correction[p] = laws.traction[p] - stiffness.cwiseProduct(jump);
  }
  equilibrium_.scatter_add({correction.data()->data(), 2 * correction.size()}, out);
}

bool System::solve_base_residual(std::span<const double> d, double load_factor, const LawValues& laws,
                                 std::span<double> y) {
  if (!loading_->dead_offset.empty() || !loading_->reference_offset.empty()) return false;
  return linear_.solve_base_residual({d, load_factor, laws.traction}, y);
}

void System::load_derivative(const LawValues& laws, std::span<double> out) const {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = -loading_->reference[i];
  if (loading_->reference_offset.empty()) return;
  std::vector<Vec2> t(laws.tangent.size());
  for (std::size_t p = 0; p < t.size(); ++p)
    t[p] = laws.tangent[p] * Eigen::Map<const Vec2>(loading_->reference_offset.data() + 2 * p);
  equilibrium_.scatter_add({t.data()->data(), 2 * t.size()}, out);
}

void System::apply_metric(Metric metric, std::span<double> v) const {
  if (metric == Metric::openings && equilibrium_.num_crackable() > 0) {
    std::vector<double> q(2 * equilibrium_.num_crackable());
    equilibrium_.gather(v, q);
    std::ranges::fill(v, 0.0);
    equilibrium_.scatter_add(q, v);
    return;
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double size = equilibrium_.block_size()[i / block_unknowns];
    if (i % block_unknowns >= 2) v[i] *= size * size;
  }
}

double System::residual_norm(std::span<const double> r) const {
  double sum = 0;
  for (std::size_t b = 0; b < equilibrium_.num_blocks(); ++b) {
    const Eigen::Map<const Vec6> at(r.data() + 6 * b);
    const double size = equilibrium_.block_size()[b];
    sum += at.head<2>().squaredNorm() + at.tail<4>().squaredNorm() / (size * size);
  }
  return std::sqrt(sum);
}

double System::force_level(std::span<const double> d) const {
  constexpr double floor = 0.1;
  return std::max(block_forces(d), floor * highest_level_);
}

double System::block_forces(std::span<const double> d) const {
  double sum = 0;
  for (std::size_t b = 0; b < equilibrium_.num_blocks(); ++b) {
    const Vec3 resultant = equilibrium_.strain_stiffness()[b] * Eigen::Map<const Vec3>(d.data() + 6 * b + 3);
    const double size = equilibrium_.block_size()[b];
    sum += resultant.squaredNorm() / (size * size);
  }
  return std::sqrt(sum);
}

double System::kappa(std::size_t p, const History& h) const {
  const InterfacePoint& point = equilibrium_.point(p);
  return std::max(h.kappa, point.law->initial_kappa(point.stiffness));
}

std::vector<History> System::next_history(std::span<const double> d, double load_factor) const {
  const std::size_t n = equilibrium_.num_crackable();
  std::vector<Vec2> q(n);
  equilibrium_.gather(*loading_, d, load_factor, {q.data()->data(), 2 * n});
  std::vector<History> out = history_;
  constexpr double round_off = 1e-10;
  for (std::size_t p = 0; p < n; ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const double reached = kappa(p, history_[p]);
    const double opening = point.law->equivalent_opening(q[p]);
    out[p].loading = opening >= reached * (1 - round_off);
    if (opening > reached) out[p].kappa = opening;
  }
  return out;
}

std::size_t System::active_set(const LawValues& laws) const {
  std::size_t hash = 1469598103934665603ull;  // FNV-1a
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const double reached = kappa(p, history_[p]);
    const double opening = point.law->equivalent_opening(laws.opening[p]);
    const bool damaged = reached > point.law->initial_kappa(point.stiffness);
    const std::size_t mode = (opening > reached ? 1u : 0u) + (damaged && laws.opening[p].x() < 0 ? 2u : 0u) +
                             (opening >= point.law->rupture_kappa(point.stiffness) ? 4u : 0u);
    hash = (hash ^ (mode + 8 * (mode ? p + 1 : 0))) * 1099511628211ull;
  }
  return hash;
}

double System::dissipated(const std::vector<History>& history) const {
  double sum = 0;
  for (std::size_t p = 0; p < history.size(); ++p) {
    if (history[p].kappa == 0) continue;
    const InterfacePoint& point = equilibrium_.point(p);
    sum += point.weight * point.law->dissipation(history[p].kappa, point.stiffness);
  }
  return sum;
}

double System::stored(const State& state, const LawValues& laws) const {
  // ½ dᵀ K_b d + ½ Σ W t·q = ½ dᵀ K0 d + ½ Σ W (t·q − P B d·B d): only crackable points are summed.
  std::vector<double> force(state.d.size(), 0.0);
  equilibrium_.intact().multiply_add(state.d, force);
  double energy = 0;
  for (std::size_t i = 0; i < force.size(); ++i) energy += 0.5 * force[i] * state.d[i];
  for (std::size_t p = 0; p < laws.traction.size(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const Vec2 jump = equilibrium_.opening(p, state.d);
    energy += 0.5 * point.weight *
              (laws.traction[p].dot(laws.opening[p]) - jump.dot(point.trial_stiffness().cwiseProduct(jump)));
  }
  for (const Spring& spring : equilibrium_.driven_springs()) {
    const double u = spring.displacement.value(state.d, state.load_factor);
    energy -= 0.5 * spring.stiffness * u * u;
  }
  return energy;
}

}  // namespace dda
