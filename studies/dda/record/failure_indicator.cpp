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

/// f = ω/2π of ω²; nan below 0.
double frequency_of(double eigenvalue) {
  return eigenvalue >= 0 ? std::sqrt(eigenvalue) / (2 * M_PI) : unknown;
}

TableCell count_cell(const std::optional<int>& count) {
  return count ? TableCell{std::int64_t{*count}} : TableCell{unknown};
}

}  // namespace

Mass mass_for(const Simulation& simulation, EigenvalueMass kind) {
  if (kind == EigenvalueMass::density) return mass_of(simulation.body());
  Mass out = unit_mass(simulation.body());
  if (kind == EigenvalueMass::unit) return out;
  const std::size_t blocks = simulation.equilibrium().num_block_nodes();
  out = Mass::identity(out.num_nodes());
  constexpr double next_to_none = 1e-9;
  for (std::size_t node = blocks; node < out.num_nodes(); ++node)
    out.diagonal[node].diagonal().tail<3>().setConstant(next_to_none);
  return out;
}

FailureIndicator::FailureIndicator(Simulation& simulation, IndicatorMemory memory)
    : simulation_(simulation),
      parameters_(simulation.deck().record.eigenvalues),
      memory_(std::move(memory)),
      tracker_(memory_.modes) {
  if (parameters_.count > 0) mass_ = mass_for(simulation_, parameters_.mass);
}

std::vector<double> FailureIndicator::followed(const std::vector<double>& shape, const Growth& growth) const {
  std::vector<double> out = growth.unknowns(shape);
  const Equilibrium& now = simulation_.equilibrium();
  out.resize(block_unknowns * now.num_leading());
  return out;
}

void FailureIndicator::follow(const Growth& growth) {
  for (auto* shapes : {&memory_.modes.shapes, &shapes_})
    for (std::vector<double>& shape : *shapes) shape = followed(shape, growth);
  tracker_ = ModeTracker(memory_.modes);
  if (parameters_.count > 0) mass_ = mass_for(simulation_, parameters_.mass);
}

RecordedColumns FailureIndicator::columns() const {
  using At = const RecordedStep&;
  RecordedColumns out;
  for (const char* kept : {"negative_", "mu_", column::rigid_modes}) out.push_back({{kept, ""}, nullptr});
  out.push_back({{column::current_stiffness, ""}, [this](At) { return stiffness_; }});
  if (simulation_.deck().path.stability) {
    out.push_back(
        {{column::negative_eigenvalues, ""}, [](At at) { return count_cell(at.point.num_negative); }});
    out.push_back({{column::negative_under_control, ""},
                   [](At at) { return count_cell(at.point.num_negative_under_control); }});
    out.push_back({{column::negative_second_order_work, ""},
                   [](At at) { return count_cell(at.point.num_negative_work); }});
  }
  if (parameters_.count == 0) return out;
  constexpr Dimension per_mass{1, -4};
  const std::string unit =
      parameters_.mass == EigenvalueMass::density
          ? "1/s^2"
          : unit_of(parameters_.mass == EigenvalueMass::unit ? per_mass : dimension::stiffness,
                    simulation_.deck().units);
  const auto count = static_cast<std::size_t>(parameters_.count);
  for (std::size_t i = 0; i < count; ++i)
    out.push_back({{column::mu(i + 1), unit}, [this, i](At) { return values_[i]; }});
  for (std::size_t i = 0; i < count; ++i)
    out.push_back({{column::mu_ratio(i + 1), ""}, [this, i](At) { return ratios_[i]; }});
  if (parameters_.mass == EigenvalueMass::density)
    for (std::size_t i = 0; i < count; ++i)
      out.push_back({{column::frequency(i + 1), "1/s"}, [this, i](At) { return frequency_of(values_[i]); }});
  out.push_back({{column::rigid_modes, ""}, [this](At) { return count_cell(num_rigid_); }});
  return out;
}

/// Rate of the load over that of the displacement on which it works, along the path.
double FailureIndicator::path_stiffness() const {
  const Tangent& leaving = simulation_.walker().leaving();
  const Loading& loading = simulation_.loading();
  if (leaving.d.empty()) return unknown;
  double rate = leaving.rate(simulation_.system().reference_work());
  for (const WorkPair& pair : loading.driven) rate += leaving.rate(pair.displacement);
  return leaving.rate(loading.load) / rate;
}

bool FailureIndicator::is_due(const RecordedStep& at) const {
  if (!tracker_.has_started()) return true;  // what all ratios refer to
  if (parameters_.every > 0 && at.now.step % parameters_.every == 0) return true;
  return std::ranges::any_of(parameters_.at, [&](const auto& event) { return at.events.contains(event); });
}

void FailureIndicator::look(const RecordedStep& at) {
  const double stiffness = path_stiffness();
  if (memory_.first_stiffness == 0) memory_.first_stiffness = stiffness;
  stiffness_ = stiffness / memory_.first_stiffness;
  values_.assign(static_cast<std::size_t>(parameters_.count), unknown);
  ratios_ = values_;
  num_rigid_.reset();
  shapes_.clear();
  if (parameters_.count > 0 && is_due(at)) find_eigenvalues();
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
std::vector<double> FailureIndicator::ratios_of(const Eigenmodes& found) {
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

void FailureIndicator::find_eigenvalues() {
  const auto scope = simulation_.system().timings().measure("eigenvalues");
  Eigenmodes found = modes(parameters_.count + memory_.spare_modes);
  if (found.values.empty()) return;
  if (!tracker_.has_started()) tracker_.start(found);
  std::vector<double> of_first = ratios_of(found);
  const bool is_lost = std::ranges::any_of(of_first, [](double ratio) { return std::isnan(ratio); });
  constexpr int of_one_fragment = 3;  // rigid motions that may have come below it
  if (is_lost && memory_.spare_modes == 0) {
    memory_.spare_modes = of_one_fragment;
    if (Eigenmodes more = modes(parameters_.count + memory_.spare_modes); !more.values.empty()) {
      found = std::move(more);
      of_first = ratios_of(found);
    }
  }
  const std::size_t count = std::min(found.values.size(), values_.size());
  std::copy_n(found.values.begin(), count, values_.begin());
  std::copy_n(of_first.begin(), std::min(of_first.size(), ratios_.size()), ratios_.begin());
  num_rigid_ = 0;
  for (std::size_t i = 0; i < count; ++i) *num_rigid_ += is_rigid(found, i);
  found.shapes.resize(count);
  shapes_ = std::move(found.shapes);
}

}  // namespace dda
