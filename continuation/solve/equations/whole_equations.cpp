#include "continuation/solve/equations/whole_equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dda {

WholeEquations::WholeEquations(System& system, const ControlEquation& control, double step,
                               const NewtonParameters& parameters, Aim aim)
    : system_(system), control_(control), step_(step), parameters_(parameters), aim_(aim) {}

WholeEquations::Known& WholeEquations::at_place(const Iterate& at) {
  if (known_.laws && at.load_factor == known_.load_factor && std::ranges::equal(at.x, known_.d))
    return known_;
  known_ = {.d = {at.x.begin(), at.x.end()},
            .load_factor = at.load_factor,
            .laws = system_.laws_at(at.x, at.load_factor),
            .residual = {}};
  return known_;
}

ControlPoint WholeEquations::control_point(const Iterate& at) {
  return {at.x, at.load_factor, *at_place(at).laws};
}

const std::vector<double>& WholeEquations::residual_at(const Iterate& at) {
  Known& here = at_place(at);
  if (here.residual.empty()) {
    here.residual.resize(size());
    system_.residual(at.x, at.load_factor, *here.laws, here.residual);
  }
  return here.residual;
}

void WholeEquations::residual(const Iterate& at, std::span<double> out) {
  std::ranges::copy(residual_at(at), out.begin());
}

double WholeEquations::norm(const Iterate& at) { return system_.residual_norm(residual_at(at)); }

void WholeEquations::load_derivative(const Iterate& at, std::span<double> out) {
  system_.load_derivative(*at_place(at).laws, out);
}

bool WholeEquations::factorise(const Iterate& at) {
  Known& here = at_place(at);
  if (here.tangent == 0) here.tangent = system_.new_stamp();
  return system_.use_tangent(here.tangent, here.laws->tangent);
}

void WholeEquations::solve(const Iterate& at, std::span<const std::span<double>> columns) {
  for (const std::span<double> column : columns) solve_base(at, column);
  system_.linear().correct(columns);
}

/// The residual far from convergence lives on the cracked points alone and needs no solve; close to it, and
/// where hardly more than weak springs hold, a true solve takes off the round-off of what was kept.
void WholeEquations::solve_base(const Iterate& at, std::span<double> column) {
  constexpr double close = 1e-6;
  const Known& here = at_place(at);
  const std::vector<double> right(column.begin(), column.end());
  if (aim_ == Aim::quick && right == here.residual &&
      system_.residual_norm(right) > close * system_.force_level(at.x) &&
      system_.solve_base_residual(at.x, at.load_factor, *here.laws, column))
    return;
  system_.linear().solve_base(right, column);
}

void WholeEquations::multiply(const Iterate&, std::span<const double> in, std::span<double> out) {
  system_.linear().multiply(in, out);
}

double WholeEquations::control(const Iterate& at) { return control_.residual(control_point(at), step_); }

double WholeEquations::control_gradient(const Iterate& at, std::span<double> per_x) {
  return control_.gradient(control_point(at), per_x);
}

Verdict WholeEquations::judge(const Iterate& at, int iterations) {
  const std::vector<double>& r = residual_at(at);
  const double norm = this->norm(at), control = std::abs(this->control(at));
  const double before = std::exchange(relative_, system_.relative(norm, at.x));
  using enum Verdict::Kind;
  if (!std::isfinite(norm + control)) return {failed, "the residual is not a number"};
  // A first iteration may close a contact and overshoot. One that grows later, far above the level of all
  // forces, would crack the whole structure, and each of its points takes columns of the update, which stay.
  constexpr double hopeless = 10;
  if (aim_ == Aim::quick && iterations > 1 && relative_ > hopeless && relative_ > before)
    return {failed, fmt::format("the iteration diverges (relative residual {:.1e})", relative_)};
  constexpr double hardly_less = 0.1;
  const bool falls = iterations > 0 && relative_ <= hardly_less * before;
  if (relative_ > parameters_.tolerance && !falls)
    relative_ = system_.excess_residual(r, at.x, at.load_factor);
  pieces_.see(system_.active_set(*at_place(at).laws));
  return verdict(relative_ <= parameters_.tolerance, control, iterations);
}

Verdict WholeEquations::verdict(bool is_equilibrium, double control, int iterations) {
  using enum Verdict::Kind;
  const bool is_improved = std::exchange(was_equilibrium_, is_equilibrium) || aim_ == Aim::quick;
  const bool meets = is_equilibrium && meets_control(control);
  control_before_ = is_equilibrium ? std::optional(control) : std::nullopt;
  if (meets && is_improved) return {converged};
  const bool takes_more = aim_ == Aim::improved && !parameters_.max_iterations;
  const int most = (takes_more ? 2 : 1) * parameters_.most();
  if (iterations >= most && is_equilibrium)
    return {failed, fmt::format("the control was met to {:.1e} only, in {} iterations", control, most)};
  if (iterations >= most)
    return {failed,
            fmt::format("no convergence in {} iterations (relative residual {:.1e})", most, relative_)};
  if (pieces_.returns() && aim_ == Aim::quick)
    return {failed, "the iteration cycles between sets of loading points"};
  // NOX itself may give up from here, and does not say why.
  return {goes_on, fmt::format("no further iterate was found (relative residual {:.1e})", relative_)};
}

/// Whether N vanishes, or only sizes the step, is small and no longer falls from one equilibrium to the next:
/// between stiff joints that is what the rounding of the openings leaves of it.
bool WholeEquations::meets_control(double control) {
  if (control <= control_tolerance) return true;
  constexpr double small = 1e-4, hardly_less = 0.1;
  return control_.only_sizes_step() && pieces_.stays() && control <= small && control_before_ &&
         control > hardly_less * *control_before_;
}

}  // namespace dda
