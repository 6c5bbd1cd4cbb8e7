#include "studies/dda/record/failure_indicator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "continuation/stability/stiffness_modes.hpp"
#include "continuation/state/history_guard.hpp"
#include "models/body/mass.hpp"
#include "studies/dda/record/measures.hpp"

namespace dda {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

TableCell count_cell(const std::optional<int>& count) {
  return count ? TableCell{std::int64_t{*count}} : TableCell{unknown};
}

}  // namespace

FailureIndicator::FailureIndicator(Simulation& simulation, IndicatorMemory memory)
    : simulation_(simulation),
      parameters_(simulation.deck().record.eigenvalues),
      memory_(std::move(memory)),
      tracker_(memory_.modes) {
  if (parameters_.count == 0) return;
  mass_.assign(simulation.equilibrium().num_blocks(), Mat6::Identity());
  if (parameters_.mass) mass_ = unit_mass(simulation.body());
}

std::vector<Column> FailureIndicator::columns() const {
  std::vector<Column> out{{"current_stiffness", ""}};
  if (simulation_.deck().path.stability) {
    out.push_back({"negative_eigenvalues", ""});
    out.push_back({"negative_under_control", ""});
    out.push_back({"negative_second_order_work", ""});
  }
  if (parameters_.count == 0) return out;
  constexpr Dimension per_mass{1, -4}, raw = dimension::stiffness;
  const std::string unit = unit_of(parameters_.mass ? per_mass : raw, simulation_.deck().units);
  for (int i = 1; i <= parameters_.count; ++i) out.push_back({"mu_" + std::to_string(i), unit});
  for (int i = 1; i <= parameters_.count; ++i) out.push_back({"mu_ratio_" + std::to_string(i), ""});
  out.push_back({"rigid_modes", ""});
  return out;
}

/// Rate of the load over that of the displacement on which it works, along the path.
double FailureIndicator::path_stiffness() const {
  const Tangent& leaving = simulation_.walker().leaving();
  const Loading& loading = simulation_.loading();
  if (leaving.d.empty()) return unknown;
  double rate = std::inner_product(leaving.d.begin(), leaving.d.end(), loading.reference_work.begin(), 0.0);
  for (const WorkPair& pair : loading.driven) rate += leaving.rate(pair.displacement);
  return leaving.rate(loading.load) / rate;
}

bool FailureIndicator::is_due(const IndicatorNow& now) const {
  if (!tracker_.has_started()) return true;  // what all ratios refer to
  if (parameters_.every > 0 && now.step % parameters_.every == 0) return true;
  return std::ranges::any_of(parameters_.at, [&](const auto& event) { return now.events.contains(event); });
}

std::vector<TableCell> FailureIndicator::cells(const IndicatorNow& now) {
  const double stiffness = path_stiffness();
  if (memory_.first_stiffness == 0) memory_.first_stiffness = stiffness;
  std::vector<TableCell> out{stiffness / memory_.first_stiffness};
  if (simulation_.deck().path.stability) {
    out.push_back(count_cell(now.num_negative));
    out.push_back(count_cell(now.num_negative_under_control));
    out.push_back(count_cell(now.num_negative_work));
  }
  shapes_.clear();
  if (parameters_.count > 0 && is_due(now)) append_eigenvalues(out);
  out.resize(columns().size(), unknown);
  return out;
}

Eigenmodes FailureIndicator::modes(int count) {
  System& system = simulation_.system();
  const Candidate& here = simulation_.walker().here();
  const HistoryGuard back(system);
  system.set_history(here.history);  // with every point that loaded up to here on its surface
  Eigenmodes out;
  try {
    const ModeRequest wanted{.count = count, .mass = mass_};
    if (auto found = stiffness_modes(system, here.state, simulation_.deck().path.linear, wanted))
      out = std::move(found->modes);
  } catch (const std::runtime_error&) {  // what the path has come to does not depend on them
  }
  return out;
}

/// μ/μ₀ of the tracked modes; nan of one that is not among those found.
std::vector<double> FailureIndicator::ratios(const Eigenmodes& found) {
  std::vector<double> out;
  const std::vector<int> places = tracker_.follow(found, mass_);
  for (std::size_t i = 0; i < places.size(); ++i)
    out.push_back(places[i] < 0
                      ? unknown
                      : found.values[static_cast<std::size_t>(places[i])] / tracker_.known().first_values[i]);
  memory_.modes = tracker_.known();
  return out;
}

/// Whether only weak springs oppose a mode, as far as rounding lets tell.
bool FailureIndicator::is_rigid(const Eigenmodes& found, std::size_t mode) const {
  const Equilibrium& equilibrium = simulation_.equilibrium();
  const std::vector<double>& shape = found.shapes[mode];
  double weak = 0;
  for (std::size_t b = 0; b < equilibrium.num_blocks(); ++b) {
    const Eigen::Map<const Vec6> at(shape.data() + block_unknowns * b);
    const double size = equilibrium.block_size()[b];
    weak += equilibrium.weak_stiffness() * (at.head<2>().squaredNorm() + size * size * at[2] * at[2]);
  }
  std::vector<double> whole = shape;
  whole.resize(equilibrium.num_unknowns(), 0.0);
  std::vector<double> terms(whole.size(), 0.0);
  equilibrium.intact().multiply_add_absolute(whole, terms);
  double absolute = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) absolute += terms[i] * std::abs(whole[i]);
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon(), clearly = 10;
  return std::abs(found.values[mode]) <= clearly * weak + rounding * absolute;
}

void FailureIndicator::append_eigenvalues(std::vector<TableCell>& out) {
  const auto scope = simulation_.system().timings().measure("eigenvalues");
  Eigenmodes found = modes(parameters_.count + memory_.spare_modes);
  if (found.values.empty()) return;
  if (!tracker_.has_started()) tracker_.start(found);
  std::vector<double> of_first = ratios(found);
  const bool is_lost = std::ranges::any_of(of_first, [](double ratio) { return std::isnan(ratio); });
  constexpr int of_one_fragment = 3;  // rigid motions that may have come below it
  if (is_lost && memory_.spare_modes == 0) {
    memory_.spare_modes = of_one_fragment;
    if (Eigenmodes more = modes(parameters_.count + memory_.spare_modes); !more.values.empty()) {
      found = std::move(more);
      of_first = ratios(found);
    }
  }
  const std::size_t count = std::min(found.values.size(), static_cast<std::size_t>(parameters_.count));
  std::int64_t rigid = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(parameters_.count); ++i)
    out.emplace_back(i < count ? found.values[i] : unknown);
  of_first.resize(static_cast<std::size_t>(parameters_.count), unknown);
  for (const double ratio : of_first) out.emplace_back(ratio);
  for (std::size_t i = 0; i < count; ++i) rigid += is_rigid(found, i);
  out.emplace_back(rigid);
  found.shapes.resize(count);
  shapes_ = std::move(found.shapes);
}

}  // namespace dda
