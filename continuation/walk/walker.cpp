#include "continuation/walk/walker.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "continuation/contact/contact_piece.hpp"
#include "continuation/state/history_guard.hpp"

namespace dda {
namespace {

/// The history, with what stands at its limit of friction said to slide, whether it has moved there or not.
std::vector<History> flagged_at_limits(const System& system, const State& state) {
  std::vector<History> out = system.history();
  const LawValues laws = system.laws(state);
  for (std::size_t p = 0; p < out.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const auto contact = point.law->contact(out[p], point.stiffness);
    if (!contact || contact->coefficient == 0) continue;
    const ContactPiece piece = piece_at(*contact, laws.opening[p], true);
    out[p].sliding = out[p].sliding || piece == ContactPiece::forward || piece == ContactPiece::backward;
  }
  return out;
}

}  // namespace

Walker::Walker(Stepper& stepper) : stepper_(stepper), system_(stepper.system()) {
  here_.state.d = std::vector<double>(system_.equilibrium().num_unknowns(), 0.0);
  here_.state.multipliers = system_.multipliers();
  here_.history = system_.history();
  begin_stage(0);
}

void Walker::begin_stage(std::size_t stage) {
  system_.set_stage(stage);
  here_.state.d = here_.state.d.all();
  here_.state.load_factor = 0;
  here_.load = value(system_.loading().load);
  fill_arriving(here_);
  set_out();
}

void Walker::set_out() {
  system_.set_history(flagged_at_limits(system_, here_.state));
  leaving_ = starting_tangent(system_, here_.state);
}

Attempt Walker::attempt(ControlEquation& control, double step, const State& guess,
                        Thoroughness thoroughness) {
  constexpr int often = 10;  // with the steps whose fields are stored by default
  const bool is_audited = (effort_.accepted + 1) % often == 0;
  Attempt out = stepper_.find({here_.state, control, step, guess, is_audited}, thoroughness);
  count_iterations();
  effort_.multiplier_iterations += out.multiplier_iterations;
  return out;
}

void Walker::count_iterations() {
  effort_.newton_iterations += stepper_.take_iterations(Unknowns::whole);
  effort_.reduced_iterations += stepper_.take_iterations(Unknowns::cracked);
}

State Walker::ahead(double amount) const {
  State out = here_.state;
  out.d = out.d.moved(amount, leaving_.d);
  out.load_factor += amount * leaving_.load_factor;
  for (std::size_t p = 0; p < out.multipliers.size(); ++p)
    out.multipliers[p] += amount * leaving_.multipliers[p];
  return out;
}

void Walker::fill_energies(Candidate& candidate) {
  const auto scope = system_.timings().measure("energies");
  const State& at = candidate.state;
  candidate.dissipated = system_.dissipated(candidate.history);
  const auto laws = system_.laws_at(at);
  candidate.stored = system_.stored(at, *laws);
  candidate.excess = strength_excess(system_, candidate.history, *laws);
  candidate.load = at.value(system_.loading().load);
}

void Walker::fill_arriving(Candidate& candidate) {
  candidate.arriving = arriving_tangent(system_, candidate.state, heading_);
  if (!parameters().stability || candidate.arriving.d.empty()) return;
  const auto scope = system_.timings().measure("stability");
  const NegativeEigenvalues found = negative_eigenvalues(system_);
  candidate.num_negative = found.of_stiffness;
  candidate.num_negative_work = found.of_symmetric_part;
}

Candidate Walker::evaluate(const Attempt& attempt) {
  Candidate out{.state = attempt.state,
                .history = system_.next_history(attempt.state),
                .arriving = {},
                .solution = attempt.solution,
                .newton_iterations = attempt.newton_iterations,
                .residual = attempt.residual,
                .multiplier_iterations = attempt.multiplier_iterations,
                .gap = attempt.gap};
  const HistoryGuard back(system_, here_.state.multipliers);
  system_.set_history(out.history);
  fill_arriving(out);
  fill_energies(out);
  const double dissipated = out.dissipated - here_.dissipated;
  const bool smooth = dissipated > 0 && leaving_.dissipates && out.arriving.dissipates;
  out.work = work_up_to(out, {here_.state, out.state, leaving_, out.arriving, smooth ? dissipated : 0.0});
  return out;
}

/// Of loads and of water in cracks.
double Walker::work_up_to(const Candidate& candidate, const Stretch& step) const {
  return here_.work + external_work(system_, step) + system_.supplied_by_water(candidate.history) -
         system_.supplied_by_water(here_.history);
}

void Walker::accept(Candidate candidate) {
  here_ = std::move(candidate);
  system_.set_history(here_.history);
  system_.set_multipliers(here_.state.multipliers);
  if (here_.state.d.are_all_known()) system_.remember_force_level(here_.state.d);
  assert(here_.solution);
  take(*std::exchange(here_.solution, {}));
  if (here_.arriving.d.empty()) fill_arriving(here_);
  leaving_ = leaving_tangent(system_, here_.state, here_.arriving, heading_);
  ++effort_.accepted;
}

/// As LOCA counts its steps.
void Walker::take(const Solution& solution) {
  const auto count = [&] { return stepper_.num_steps(solution.unknowns); };
  const int before = count();
  stepper_.accept(solution, here_.state);
  (solution.unknowns == Unknowns::cracked ? effort_.cracked_steps : effort_.whole_steps) += count() - before;
}

bool Walker::confirm(Candidate& candidate) {
  const State& at = candidate.state;
  const HistoryGuard back(system_, here_.state.multipliers);
  system_.set_history(candidate.history);
  system_.set_multipliers(at.multipliers);
  const auto load = make_gauge_equation({.rows = {}, .per_load_factor = 1});
  load->start_at(ControlPoint::at(at, *system_.laws_at(at)), 1);
  WholeEquations equations(system_, *load, 0, parameters().newton);
  const Solved found = stepper_.solve({equations, {at.d, at.load_factor}});
  count_iterations();
  if (found.converged) candidate.solution = Solution{};
  return found.converged;
}

Candidate Walker::settled(const Settled& found) {
  count_iterations();
  Candidate next{
      .state = found.state, .history = found.history, .arriving = {}, .newton_iterations = found.iterations};
  const HistoryGuard back(system_, here_.state.multipliers);
  system_.set_history(next.history);
  system_.set_multipliers(next.state.multipliers);
  fill_energies(next);
  next.residual = system_.excess_residual(next.state);
  if (system_.iterates_multipliers()) next.gap = system_.relative_gap(*system_.laws_at(next.state));
  next.work = work_up_to(next, {here_.state, next.state, leaving_, {}});
  return next;
}

double Walker::jump(Candidate next) {
  const double released =
      (next.work - here_.work) - (next.stored - here_.stored) - (next.dissipated - here_.dissipated);
  accept(std::move(next));
  return released;
}

void Walker::unload() {
  for (History& h : here_.history) h.loading = h.sliding = false;
  system_.set_history(here_.history);
  leaving_ = arriving_tangent(system_, here_.state, heading_);
}

void Walker::leave_beyond(BeyondChange change) {
  if (!leaving_.dissipates || leaving_.opening[change.point].dot(change.across) >= 0) return;
  change.arriving = here_.arriving;
  std::vector<History> flags = system_.history();
  system_.set_history(here_.history);
  if (auto found = tangent_beyond(system_, here_.state, heading_, change))
    leaving_ = *std::move(found);
  else
    system_.set_history(std::move(flags));
}

void Walker::turn_to(Tangent leaving, std::vector<History> flags) {
  system_.set_history(std::move(flags));
  leaving_ = std::move(leaving);
}

Growth Walker::follow(const std::function<Growth()>& remake) {
  const std::vector<double> before = here_.state.d.all(), along = leaving_.d;
  Growth growth = system_.follow(remake);
  stepper_.begin_anew();
  here_.state.d = growth.unknowns(before);
  here_.state.multipliers = system_.multipliers();
  here_.history = system_.history();
  here_.arriving = {};
  if (along.empty()) return growth;
  leaving_.d = growth.unknowns(along);
  leaving_.opening = growth.of_points(leaving_.opening);
  if (!leaving_.multipliers.empty()) leaving_.multipliers = growth.of_points(leaving_.multipliers);
  return growth;
}

void Walker::restore(Candidate at, const Effort& effort, Tangent leaving) {
  here_ = std::move(at);
  system_.set_history(here_.history);
  system_.set_multipliers(here_.state.multipliers);
  effort_ = effort;
  leaving_ = std::move(leaving);
}

}  // namespace dda
