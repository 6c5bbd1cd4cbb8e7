// Solutions with the base that are kept, and what is put together from them.
#include <algorithm>
#include <utility>

#include "continuation/linear/linear_system.hpp"

namespace dda {

/// A combination, as long as its base is there.
class LinearSystem::Combined final : public Displacements::Completion {
 public:
  Combined(LinearSystem& linear, Combination of) : linear_(linear), of_(std::move(of)) {}
  std::vector<double> all() const override { return linear_.combined_everywhere(of_); }

 private:
  LinearSystem& linear_;
  const Combination of_;
};

void LinearSystem::begin_stage(const Loading& stage) {
  complete_pending();
  reference_ = {stage.reference, {}};
  dead_ = {stage.dead, {}};
  watched_ = equilibrium_.watched(stage);
  if (columns_) columns_->watch(watched_);
}

const std::vector<double>& LinearSystem::solution_of(Kept& kept) {
  if (!kept.solution.empty()) return kept.solution;
  const auto scope = timings_->measure("solutions");
  kept.solution = kept.right;
  if (std::ranges::all_of(kept.right, [](double value) { return value == 0; })) return kept.solution;
  solve_with_base(kept.solution);
  std::vector<double> rest(n());  // refined once: iterates that are put together from it cannot be
  multiply(base_, kept.solution, rest);
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = kept.right[i] - rest[i];
  solve_with_base(rest);
  for (std::size_t i = 0; i < rest.size(); ++i) kept.solution[i] += rest[i];
  return kept.solution;
}

/// The base is symmetric: Zᵀ g = U K_base⁻¹ g.
Eigen::VectorXd LinearSystem::along_columns(const Functional& gauge) {
  auto kept = std::ranges::find(gauges_, gauge.rows, &KeptGauge::rows);
  if (kept == gauges_.end()) {
    constexpr std::size_t most_kept = 8;  // of controls that come back; those of one step are not worth more
    if (gauges_.size() == most_kept) gauges_.erase(gauges_.begin());
    Kept wanted{std::vector<double>(n(), 0.0), {}};
    gauge.add_gradient(1, wanted.right);
    kept = gauges_.insert(gauges_.end(), KeptGauge{gauge.rows, solution_of(wanted)});
  }
  const std::vector<double>& solution = kept->solution;
  Eigen::VectorXd out(2 * static_cast<Eigen::Index>(updated_.size()));
  for (std::size_t i = 0; i < updated_.size(); ++i)
    out.segment<2>(2 * static_cast<Eigen::Index>(i)) = rows_times(updated_[i], solution);
  return out;
}

std::vector<double> LinearSystem::combined_everywhere(const Combination& of) {
  std::vector<double> out = of.origin ? *of.origin : dead_solution();
  const std::vector<double>& live = reference_solution();
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += of.load_factor * live[i];
  const std::span<double> d(out);
  subtract_columns(of.points, of.z, std::span<const std::span<double>>(&d, 1));
  return out;
}

Displacements LinearSystem::combined(Combination of) {
  const Displacements::Nodes nodes = columns_->narrow_nodes();
  if (!nodes || of.points.empty()) return combined_everywhere(of);
  const std::vector<double>&origin = of.origin ? *of.origin : dead_solution(), &live = reference_solution();
  std::vector<double> out(n(), 0.0);
  for (std::size_t i = 0; i < out.size(); ++i)
    if ((*nodes)[i / block_unknowns]) out[i] = origin[i] + of.load_factor * live[i];
  {
    const auto scope = timings_->measure("products");
    columns_->subtract_watched(places_of(of.points), of.z, out);
  }
  const auto dead_work = of.dead_work;
  const Displacements known(std::move(out), nodes, std::make_unique<Combined>(*this, std::move(of)),
                            dead_work);
  std::erase_if(pending_, [](const Displacements::Pending& pending) { return pending.is_over(); });
  pending_.emplace_back(known);
  return known;
}

void LinearSystem::complete_pending() {
  for (const Displacements::Pending& pending : pending_) pending.complete();
  pending_.clear();
}

}  // namespace dda
