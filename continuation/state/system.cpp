#include "continuation/state/system.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "continuation/state/at_once.hpp"
#include "continuation/state/least_memory.hpp"
#include "framework/base/threads.hpp"
#include "models/equilibrium/stiffness_parts.hpp"

namespace dda {

System::System(const Equilibrium& equilibrium, const DirectSolverChoice& solver, LinearSystem::Update update)
    : equilibrium_(equilibrium),
      loading_(nullptr),
      linear_(equilibrium, affordable_solver(equilibrium, solver), update),
      solver_(solver),
      history_(equilibrium.num_active()) {
  for (std::size_t p = 0; p < equilibrium.num_active() && !physical_; ++p)
    if (equilibrium.point(p).multiplier == Multiplier::iterated) {
      physical_ = std::make_unique<LinearSystem>(equilibrium, solver, update);
      multipliers_.assign(equilibrium.num_active(), Vec2::Zero());
    }
  make_screen();
  joins_by_contact_ = has_contacts();
  set_stage(0);
}

Growth System::follow(const std::function<Growth()>& remake) {
  for (LinearSystem* linear : {&linear_, physical_.get(), contact_.get()})
    if (linear) linear->let_go();
  remembered_.laws.reset();
  const auto stage = static_cast<std::size_t>(loading_ - equilibrium_.stages().data());
  Growth growth = remake();
  history_ = growth.of_points(history_);
  if (!multipliers_.empty()) multipliers_ = growth.of_points(multipliers_);
  path_tangent_.clear();
  used_stamp_ = 0;
  for (LinearSystem* linear : {&linear_, physical_.get(), contact_.get()})
    if (linear) linear->follow(growth);
  make_screen();
  set_stage(stage);
  return growth;
}

void System::make_screen() {
  screen_.clear();
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const double beta = point.law->shear_weight();
    screen_.push_back({0, beta * beta, point.intact_stiffness()});
  }
  screen_intact_points();
}

void System::measure_with(Timings& timings) {
  timings_ = &timings;
  linear_.measure_with(timings);
  for (LinearSystem* other : {physical_.get(), contact_.get()})
    if (other) other->measure_with(timings);
}

void System::set_stage(std::size_t stage) {
  loading_ = &equilibrium_.stages()[stage];
  remembered_.laws.reset();
  std::vector<double> springs = loading_->dead;
  has_dead_ = std::ranges::any_of(springs, [](double force) { return force != 0; });
  for (std::size_t i = 0; i < loading_->dead_work.size(); ++i) springs[i] -= loading_->dead_work[i];
  reference_ = reference_work_ = dead_springs_ = {};
  reference_.add_rows(1, loading_->reference);
  reference_work_.add_rows(1, loading_->reference_work);
  dead_springs_.add_rows(1, springs);
  loaded_.clear();
  const auto part = [](const std::vector<double>& work, std::size_t node) -> Vec6 {
    return work.empty() ? Vec6::Zero() : Vec6(Eigen::Map<const Vec6>(work.data() + block_unknowns * node));
  };
  for (std::size_t node = 0; node < equilibrium_.num_block_nodes(); ++node)
    if (const Loaded now{node, part(loading_->dead_work, node), part(loading_->reference_work, node)};
        !now.dead.isZero(0) || !now.live.isZero(0))
      loaded_.push_back(now);
  linear_.begin_stage(*loading_);
  for (LinearSystem* other : {physical_.get(), contact_.get()})
    if (other) other->begin_stage(*loading_);
}

LinearSystem& System::contact_linear() {
  if (contact_) return *contact_;
  contact_ = std::make_unique<LinearSystem>(equilibrium_, solver_, LinearSystem::Update::low_rank);
  contact_->measure_with(*timings_);
  contact_->begin_stage(*loading_);
  return *contact_;
}

bool System::has_contacts() const {
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    if (point.law->contact(history_[p], point.stiffness)) return true;
  }
  return false;
}

void System::set_multipliers(const std::vector<Vec2>& m) {
  if (multipliers_.empty()) return;
  multipliers_ = m;
  if (m.empty()) multipliers_.assign(equilibrium_.num_active(), Vec2::Zero());
  remembered_.laws.reset();
}

std::vector<Vec2> System::next_multipliers(const LawValues& laws) const {
  std::vector<Vec2> out = multipliers_;
  for (std::size_t p = 0; p < out.size(); ++p)
    if (const InterfacePoint& point = equilibrium_.point(p); point.multiplier == Multiplier::iterated)
      out[p] = laws.traction[p].cwiseQuotient((1 + point.perturbation) * point.trial_stiffness());
  return out;
}

double System::relative_gap(const LawValues& laws) const {
  const std::vector<Vec2> next = next_multipliers(laws);
  double gap = 0, unit = 0;
  for (std::size_t p = 0; p < next.size(); ++p) {
    gap = std::max(gap, (next[p] - multipliers_[p]).norm());
    const InterfacePoint& point = equilibrium_.point(p);
    const double carried =
        (1 + point.perturbation) * point.trial_stiffness().cwiseProduct(multipliers_[p]).norm();
    unit = std::max(unit, std::max(laws.traction[p].norm(), carried) / point.spring_unit);
  }
  return unit > 0 ? gap / unit : 0;
}

std::vector<Vec2> System::openings(std::span<const double> d, double load_factor) const {
  const std::size_t n = equilibrium_.num_active();
  std::vector<Vec2> out(n);
  equilibrium_.gather(*loading_, d, load_factor, components(out));
  for (std::size_t p = 0; p < multipliers_.size(); ++p) out[p] += multipliers_[p];
  return out;
}

std::vector<Vec2> System::openings(const Displacements& d, double load_factor) const {
  if (!d.sum()) return openings(std::span<const double>(d.all()), load_factor);
  std::vector<Vec2> out = d.sum()->openings();
  for (std::size_t p = 0; p < out.size(); ++p) {
    out[p] += loading_->dead_opening(p) + load_factor * loading_->reference_opening(p);
    if (!multipliers_.empty()) out[p] += multipliers_[p];
  }
  return out;
}

void System::set_history(std::vector<History> history) {
  history_ = std::move(history);
  remembered_.laws.reset();
  screen_intact_points();
}

void System::screen_intact_points() {
  constexpr double inside = 1 - 1e-9;  // at the bound itself the law decides
  parallel_for(screen_.size(), points_at_once, [&](std::size_t p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const History& h = history_[p];
    const bool is_idle = !h.loading && !h.sliding && h.dissipated == 0;
    const double bound = is_idle ? inside * point.law->intact_bound(h, point.stiffness) : 0;
    screen_[p].bound = bound * bound;
  });
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
  if (!remembered_.laws || remembered_.at.load_factor != load_factor || remembered_.at.d.sum() ||
      !std::ranges::equal(remembered_.at.d.all(), d)) {
    remembered_.laws = std::make_shared<const LawValues>(laws(d, load_factor));
    remembered_.at = {std::vector<double>(d.begin(), d.end()), load_factor};
  }
  return remembered_.laws;
}

std::shared_ptr<const LawValues> System::laws_at(const State& at) {
  if (!remembered_.laws || remembered_.at.load_factor != at.load_factor ||
      (!remembered_.at.d.is_same_as(at.d) &&
       (remembered_.at.d.sum() || at.d.sum() || remembered_.at.d.all() != at.d.all())))
    remembered_ = {at, std::make_shared<const LawValues>(laws(at))};
  return remembered_.laws;
}

LawValues System::laws(std::span<const double> d, double load_factor) const {
  return laws_of(openings(d, load_factor));
}

LawValues System::laws_of(std::vector<Vec2> openings) const {
  const auto scope = timings_->measure("laws");
  const std::size_t n = equilibrium_.num_active();
  LawValues out{std::move(openings), std::vector<Vec2>(n), std::vector<Mat2>(n)};
  std::atomic<std::int64_t> num_screened = 0;
  parallel_pieces(n, points_at_once, [&](std::size_t begin, std::size_t end) {
    std::int64_t screened = 0;
    for (std::size_t p = begin; p < end; ++p) {
      const Vec2& q = out.opening[p];
      const double normal = std::max(q.x(), 0.0);
      if (const Screen& s = screen_[p]; normal * normal + s.shear * q.y() * q.y() < s.bound) {
        out.traction[p] = s.stiffness.cwiseProduct(q);
        out.tangent[p] = s.stiffness.asDiagonal();
        ++screened;
      } else {
        const Response response = respond(p, q);
        out.traction[p] = response.traction;
        out.tangent[p] = response.tangent;
      }
    }
    num_screened += screened;
  });
  num_screened_ += num_screened;
  return out;
}

Response System::respond(std::size_t p, const Vec2& q) const {
  const InterfacePoint& point = equilibrium_.point(p);
  return frozen_ ? point.law->respond_frozen(q, history_[p], point.stiffness)
                 : point.law->respond(q, history_[p], point.stiffness);
}

void System::residual(std::span<const double> d, double load_factor, const LawValues& laws,
                      std::span<double> out) const {
  const auto scope = timings_->measure("residuals");
  parallel_for(out.size(), numbers_at_once,
               [&](std::size_t i) { out[i] = -loading_->dead[i] - load_factor * loading_->reference[i]; });
  equilibrium_.unjoined().multiply_add(d, out);
  std::vector<Vec2> correction(laws.traction.size());
  parallel_for(correction.size(), points_at_once, [&](std::size_t p) {
    const Vec2 stiffness = equilibrium_.unjoined_stiffness(p);
    Vec2 jump = laws.opening[p] - loading_->dead_opening(p) - load_factor * loading_->reference_opening(p);
    if (!multipliers_.empty()) jump -= multipliers_[p];
    correction[p] = laws.traction[p] - stiffness.cwiseProduct(jump);
  });
  equilibrium_.scatter_add(components(correction), out);
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
  for (std::size_t p = 0; p < t.size(); ++p) t[p] = laws.tangent[p] * loading_->reference_opening(p);
  equilibrium_.scatter_add(components(t), out);
}

BlockMatrix System::stiffness(const State& state) const {
  std::vector<Mat2> tangents = laws(state).tangent;
  for (Mat2& d : tangents) d = 0.5 * (d + d.transpose()).eval();
  return linear_.matrix_with(tangents);
}

void System::apply_metric(Metric metric, std::span<double> v) const {
  if (metric == Metric::openings && equilibrium_.num_active() > 0) {
    std::vector<double> q(2 * equilibrium_.num_active());
    equilibrium_.gather(v, q);
    std::ranges::fill(v, 0.0);
    equilibrium_.scatter_add(q, v);
    return;
  }
  const std::size_t of_blocks = block_unknowns * equilibrium_.num_block_nodes();
  for (std::size_t i = 0; i < of_blocks; ++i) {
    const std::size_t node = i / block_unknowns;
    const double size = *equilibrium_.strain_size(node);
    if (i % block_unknowns >= 2 || node >= equilibrium_.num_blocks()) v[i] *= size * size;
  }
  std::ranges::fill(v.subspan(of_blocks), 0.0);
}

double System::square_of_residual(BlockId node, const Vec6& r) const {
  const std::optional<double> of_strains = equilibrium_.strain_size(node.value());
  if (!of_strains) return r.squaredNorm();
  const double size = *of_strains;
  if (node.value() >= equilibrium_.num_blocks()) return r.squaredNorm() / (size * size);
  return r.head<2>().squaredNorm() + r.tail<4>().squaredNorm() / (size * size);
}

double System::residual_norm(std::span<const double> r) const {
  return std::sqrt(parallel_sum(equilibrium_.num_nodes(), blocks_at_once, [&](std::size_t b) {
    return square_of_residual(BlockId{b}, Eigen::Map<const Vec6>(r.data() + block_unknowns * b));
  }));
}

std::vector<double> System::rounding_of_forces(std::span<const double> d, double load_factor) const {
  std::vector<double> out(d.size());
  parallel_for(out.size(), numbers_at_once, [&](std::size_t i) {
    out[i] = std::abs(loading_->dead[i]) + std::abs(load_factor * loading_->reference[i]);
  });
  equilibrium_.add_absolute_products(d, out);
  parallel_for(out.size(), numbers_at_once,
               [&](std::size_t i) { out[i] *= equilibrium_.rounding_of_sums()[i / block_unknowns]; });
  return out;
}

double System::excess_residual(std::span<const double> r, std::span<const double> d,
                               double load_factor) const {
  const std::vector<double> rounding = rounding_of_forces(d, load_factor);
  const auto beyond_rounding = [&](std::span<const double> forces) {
    std::vector<double> terms(d.size());
    parallel_for(terms.size(), numbers_at_once,
                 [&](std::size_t i) { terms[i] = std::max(0.0, std::abs(forces[i]) - rounding[i]); });
    return residual_norm(terms);
  };
  std::vector<double> own(r.begin(), r.end());
  equilibrium_.subtract_weak_forces(d, own);
  return relative(std::min(beyond_rounding(r), beyond_rounding(own)), d);
}

double System::rounding_of_work(const State& from, const State& to) const {
  const std::vector<double> forces = rounding_of_forces(to.d, to.load_factor);
  return parallel_sum(forces.size(), numbers_at_once,
                      [&](std::size_t i) { return forces[i] * std::abs(to.d[i] - from.d[i]); });
}

double System::weak_forces(std::span<const double> d) const {
  return equilibrium_.weak_stiffness() *
         parallel_sum(equilibrium_.num_blocks(), blocks_at_once, [&](std::size_t b) {
           return Eigen::Map<const Vec2>(d.data() + block_unknowns * b).norm();
         });
}

double System::excess_residual(const State& at) {
  std::vector<double> r(at.d.size());
  residual(at.d, at.load_factor, *laws_at(at), r);
  return excess_residual(r, at.d, at.load_factor);
}

double System::relative(double residual_norm, std::span<const double> d) const {
  const double level = force_level(d);
  return level > 0 ? residual_norm / level : (residual_norm > 0 ? 1.0 : 0.0);
}

double System::force_level(std::span<const double> d) const {
  return std::max(block_forces(d), least_force_level());
}

double System::kappa(std::size_t p, const History& h) const {
  const InterfacePoint& point = equilibrium_.point(p);
  return point.law->kappa(h, point.stiffness);
}

bool System::is_spent(std::size_t p) const {
  const InterfacePoint& point = equilibrium_.point(p);
  return point.law->is_spent(history_[p], point.stiffness);
}

bool System::is_broken(std::size_t p) const {
  const InterfacePoint& point = equilibrium_.point(p);
  return point.law->is_broken(history_[p], point.stiffness);
}

bool System::is_damaged() const {
  for (std::size_t p = 0; p < history_.size(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    if (!point.is_separate() && point.law->damage(history_[p], point.stiffness) > 0) return true;
  }
  return false;
}

std::vector<History> System::next_history(const State& at) const {
  const std::vector<Vec2> q = openings(at.d, at.load_factor);
  std::vector<History> out = history_;
  parallel_for(q.size(), points_at_once, [&](std::size_t p) {
    const InterfacePoint& point = equilibrium_.point(p);
    out[p] = point.law->accept(q[p], history_[p], point.stiffness);
  });
  return out;
}

std::size_t System::active_set(const LawValues& laws) const {
  std::size_t hash = 1469598103934665603ull;  // FNV-1a
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const std::size_t piece = point.law->piece(laws.opening[p], history_[p], point.stiffness);
    hash = (hash ^ (piece + 32 * (piece ? p + 1 : 0))) * 1099511628211ull;
  }
  return hash;
}

}  // namespace dda
