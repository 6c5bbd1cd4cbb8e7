// Solutions with the base that are kept, what is put together from them, and what follows from couplings alone.
#include <algorithm>
#include <numeric>
#include <utility>

#include "continuation/linear/dense/dense_product.hpp"
#include "continuation/linear/linear_system.hpp"
#include "framework/base/threads.hpp"

namespace dda {
namespace {

bool is_none(const std::vector<double>& force) {
  return std::ranges::all_of(force, [](double value) { return value == 0; });
}

}  // namespace

/// A combination, as long as its base is there. Openings and gauges follow from the couplings of the points:
///
///     B d = s B d₀ + λ B d_ref − G z,     g · d = s g · d₀ + λ g · d_ref − (Zᵀ g) · z
class LinearSystem::Combined final : public Displacements::Sum {
 public:
  Combined(LinearSystem& linear, Combination of) : linear_(linear), of_(std::move(of)) {}

  const Combination& combination() const { return of_; }
  std::size_t size() const override { return linear_.n(); }
  std::vector<double> all() const override { return linear_.combined_everywhere(of_); }

  const std::vector<Vec2>& openings() const override {
    if (openings_.empty()) find_openings();
    return openings_;
  }

  double product(const Functional& gauge) const override {
    const auto of = [&](const std::vector<double>& d) { return gauge.value(d, 0) - gauge.constant; };
    double out = of_.load_factor * of(linear_.reference_solution());
    if (of_.share != 0) out += of_.share * of(origin());
    return of_.z.size() == 0 ? out : out - linear_.along_columns(gauge).head(of_.z.size()).dot(of_.z);
  }

  /// Zᵀ f_dead are the openings of K_base⁻¹ f_dead.
  double dead_work() const override {
    const std::vector<double>& force = linear_.dead_.right;
    double out = of_.load_factor * linear_.dead_work_of(linear_.reference_);
    if (of_.share != 0)
      out +=
          of_.share * (of_.origin ? std::inner_product(force.begin(), force.end(), of_.origin->begin(), 0.0)
                                  : linear_.dead_work_of(linear_.dead_));
    const std::vector<Vec2>& openings = linear_.openings_of(linear_.dead_);
    for (Eigen::Index i = 0; i < of_.z.size(); i += 2)
      out -= of_.z.segment<2>(i).dot(openings[linear_.updated_[static_cast<std::size_t>(i / 2)]]);
    return out;
  }

  std::shared_ptr<const Sum> combined(double a, double b, const Sum& other) const override {
    const auto* with = dynamic_cast<const Combined*>(&other);
    if (!with || &with->linear_ != &linear_) return nullptr;
    const Combination& its = with->of_;
    const double own = a * of_.share, others = b * its.share;
    if (own != 0 && others != 0 && of_.origin != its.origin) return nullptr;
    Combination out{.origin = own != 0 ? of_.origin : its.origin,
                    .share = own + others,
                    .load_factor = a * of_.load_factor + b * its.load_factor,
                    .z = Eigen::VectorXd::Zero(std::max(of_.z.size(), its.z.size()))};
    out.z.head(of_.z.size()) += a * of_.z;
    out.z.head(its.z.size()) += b * its.z;
    return std::make_shared<const Combined>(linear_, std::move(out));
  }

  void note(const Displacements::Pending& displacements) const override {
    std::erase_if(linear_.pending_, [](const Displacements::Pending& pending) { return pending.is_over(); });
    linear_.pending_.push_back(displacements);
  }

 private:
  const std::vector<double>& origin() const { return of_.origin ? *of_.origin : linear_.dead_solution(); }

  void find_openings() const {
    const auto scope = linear_.timings_->measure("openings");
    const std::vector<Vec2>& live = linear_.openings_of(linear_.reference_);
    std::vector<Vec2> start(live.size(), Vec2::Zero());
    if (of_.share != 0 && of_.origin)
      linear_.equilibrium_.gather(*of_.origin, components(start));
    else if (of_.share != 0)
      start = linear_.openings_of(linear_.dead_);
    openings_.resize(live.size());
    for (std::size_t p = 0; p < live.size(); ++p)
      openings_[p] = of_.share * start[p] + of_.load_factor * live[p];
    if (of_.z.size() == 0) return;
    const Eigen::VectorXd opened = linear_.coupled(of_.z);
    for (std::size_t p = 0; p < live.size(); ++p) openings_[p] -= opened.segment<2>(2 * linear_.slot_[p]);
  }

  LinearSystem& linear_;
  const Combination of_;
  mutable std::vector<Vec2> openings_;
};

void LinearSystem::begin_stage(const Loading& stage) {
  settle_pending();
  if (reference_.right != stage.reference) reference_ = {stage.reference};
  if (dead_.right != stage.dead) dead_ = {stage.dead};
  reference_.dead_work.reset();
}

const std::vector<double>& LinearSystem::solution_of(Kept& kept) {
  if (!kept.solution.empty()) return kept.solution;
  const auto scope = timings_->measure("solutions");
  kept.solution = kept.right;
  if (is_none(kept.right)) return kept.solution;
  solve_load_with_base(kept.solution);
  std::vector<double> rest(n());  // refined once: iterates that are put together from it cannot be
  multiply(base_, kept.solution, rest);
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = kept.right[i] - rest[i];
  solve_with_base(rest);
  for (std::size_t i = 0; i < rest.size(); ++i) kept.solution[i] += rest[i];
  return kept.solution;
}

const std::vector<Vec2>& LinearSystem::openings_of(Kept& kept) {
  if (!kept.openings.empty()) return kept.openings;
  kept.openings.resize(equilibrium_.num_active());
  equilibrium_.gather(solution_of(kept), components(kept.openings));
  return kept.openings;
}

double LinearSystem::dead_work_of(Kept& kept) {
  if (kept.dead_work) return *kept.dead_work;
  const std::vector<double>&force = dead_.right, &d = solution_of(kept);
  kept.dead_work = is_none(force) ? 0 : std::inner_product(force.begin(), force.end(), d.begin(), 0.0);
  return *kept.dead_work;
}

const Eigen::VectorXd& LinearSystem::along_columns(const Functional& gauge) {
  auto kept = std::ranges::find(gauges_, gauge.rows, &KeptGauge::rows);
  if (kept == gauges_.end()) {
    constexpr std::size_t most_kept = 64;  // of gauges that come back; those of one step are not worth more
    if (gauges_.size() == most_kept) gauges_.erase(gauges_.begin());
    kept = gauges_.insert(gauges_.end(), KeptGauge{gauge.rows, {}});
  }
  if (kept->along.size() != 2 * std::ssize(updated_)) {
    const auto scope = timings_->measure("columns");
    kept->along = columns_->along(gauge);
  }
  return kept->along;
}

Eigen::VectorXd LinearSystem::coupled(const Eigen::VectorXd& z) const {
  constexpr std::size_t rows_at_once = 500;
  Eigen::VectorXd out = Eigen::VectorXd::Zero(2 * std::ssize(updated_));
  parallel_pieces(
      static_cast<std::size_t>(out.size()), rows_at_once, [&](std::size_t begin, std::size_t end) {
        const auto first = static_cast<Eigen::Index>(begin), rows = static_cast<Eigen::Index>(end - begin);
        for (Eigen::Index i = 0; i < z.size(); i += 2)
          if (!z.segment<2>(i).isZero(0))
            out.segment(first, rows).noalias() += g_.block(first, i, rows, 2) * z.segment<2>(i);
      });
  return out;
}

std::optional<Eigen::MatrixXd> LinearSystem::flexibility(std::span<const Hinge> hinges) {
  std::vector<std::size_t> unknown;
  for (const Hinge& hinge : hinges)
    if (!has_columns(hinge.point)) unknown.push_back(hinge.point);
  if (!updates() || (!unknown.empty() && !make_columns(unknown))) return {};
  const auto n = std::ssize(hinges), r = 2 * std::ssize(active_);
  Eigen::MatrixXd out(n, n), left(r, n), right(r, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Hinge& at = hinges[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < n; ++i) {
      const Hinge& seen = hinges[static_cast<std::size_t>(i)];
      out(i, j) = seen.component.dot(coupling(seen.point, at.point) * at.force);
    }
    for (Eigen::Index row = 0; row < r; row += 2) {
      const std::size_t p = active_[static_cast<std::size_t>(row / 2)];
      left.block<2, 1>(row, j) = coupling(at.point, p).transpose() * at.component;
      right.block<2, 1>(row, j) = update_of(p) * (coupling(p, at.point) * at.force);
    }
  }
  if (r > 0) out -= product_of_transpose(left, small_.solve(std::move(right)));
  return out;
}

std::vector<double> LinearSystem::combined_everywhere(const Combination& of) {
  std::vector<double> out = of.origin ? *of.origin : dead_solution();
  const std::vector<double>& live = reference_solution();
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = of.share * out[i] + of.load_factor * live[i];
  std::vector<std::size_t> points;
  std::vector<double> z;
  for (Eigen::Index i = 0; i < of.z.size(); i += 2) {
    if (of.z.segment<2>(i).isZero(0)) continue;
    points.push_back(updated_[static_cast<std::size_t>(i / 2)]);
    z.insert(z.end(), {of.z[i], of.z[i + 1]});
  }
  const std::span<double> d(out);
  subtract_columns(points, Eigen::Map<const Eigen::VectorXd>(z.data(), std::ssize(z)), {&d, 1});
  return out;
}

Displacements LinearSystem::combined(Combination of) {
  if (!takes_all_ || (of.z.size() > 0 && !has_all_columns())) return combined_everywhere(of);
  return {std::make_shared<const Combined>(*this, std::move(of))};
}

Displacements LinearSystem::reference_direction() {
  if (!takes_all_) {
    std::vector<double> out = reference_solution();
    const std::span<double> d(out);
    correct({&d, 1});
    return out;
  }
  Combination out{.share = 0, .load_factor = 1, .z = Eigen::VectorXd::Zero(2 * std::ssize(updated_))};
  if (active_.empty()) return combined(std::move(out));
  Eigen::VectorXd right(2 * std::ssize(active_));
  const std::vector<Vec2>& openings = openings_of(reference_);
  for (std::size_t a = 0; a < active_.size(); ++a)
    right.segment<2>(2 * static_cast<Eigen::Index>(a)) = update_of(active_[a]) * openings[active_[a]];
  const Eigen::MatrixXd shares = small_.solve(std::move(right));
  for (std::size_t a = 0; a < active_.size(); ++a)
    out.z.segment<2>(2 * slot_[active_[a]]) = shares.block<2, 1>(2 * static_cast<Eigen::Index>(a), 0);
  return combined(std::move(out));
}

std::optional<LinearSystem::Combination> LinearSystem::combination_of(const Displacements& d) {
  const auto* sum = dynamic_cast<const Combined*>(d.sum());
  return sum ? std::optional(sum->combination()) : std::nullopt;
}

void LinearSystem::settle_pending() {
  for (const Displacements::Pending& pending : pending_) pending.settle();
  pending_.clear();
}

}  // namespace dda
