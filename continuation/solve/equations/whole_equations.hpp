#pragma once

#include <memory>
#include <optional>

#include "continuation/equation/control_equation.hpp"
#include "continuation/solve/equations/equations.hpp"
#include "continuation/solve/equations/pieces_watch.hpp"

namespace dda {

/// What NOX makes of a Newton step.
enum class LineSearch { full_step, backtrack, polynomial };

/// How a Newton iteration goes on, and when it ends.
struct NewtonParameters {
  double tolerance = 1e-9;  ///< ‖R‖ relative to the force level of the blocks
  std::optional<int> max_iterations =
      {};  ///< of any iteration or walks; none: `usual`, or more where that helps
  LineSearch line_search = LineSearch::full_step;
  std::optional<double> reduction = {};  ///< of `backtrack`
  int output = 0;                        ///< NOX's and LOCA's, into a file (Stepper::log_to); bits

  static constexpr int usual = 15;
  int most() const { return max_iterations.value_or(usual); }
};

/// Largest |N| of a control that counts as none.
inline constexpr double control_tolerance = 1e-8;

/// Equilibrium of all blocks, F = R(d, λ) (System), under a control.
///
/// Converged when equilibrium and control hold; a residual that does not fall counts without its rounding
/// (System::excess_residual), a control that rounding keeps from falling counts as met. Failed on NaN, on too
/// many iterations, and as soon as the set of loading points comes back to one it has left (PiecesWatch).
class WholeEquations final : public Equations {
 public:
  /// How patient the iteration is.
  enum class Aim {
    quick,    ///< fails early: a shorter step may do
    improved  ///< for a line search: sets may come back, and what has converged is improved once more
  };
  WholeEquations(System& system, const ControlEquation& control, double step,
                 const NewtonParameters& parameters, Aim aim = Aim::quick);

  Unknowns unknowns() const override { return Unknowns::whole; }
  std::size_t size() const override { return system_.equilibrium().num_unknowns(); }
  void residual(const Iterate& at, std::span<double> out) override;
  double norm(const Iterate& at) override;
  void load_derivative(const Iterate& at, std::span<double> out) override;
  bool factorise(const Iterate& at) override;
  void solve(const Iterate& at, std::span<const std::span<double>> columns) override;
  void multiply(const Iterate& at, std::span<const double> in, std::span<double> out) override;
  double control(const Iterate& at) override;
  double control_gradient(const Iterate& at, std::span<double> per_x) override;
  double per_path() const override { return control_.per_path(); }
  Verdict judge(const Iterate& at, int iterations) override;

  /// Of the last iterate that was judged, relative to the force level.
  double relative_residual() const { return relative_; }

 private:
  /// What is known at one iterate.
  struct Known {
    std::vector<double> d;
    double load_factor = 0;
    std::shared_ptr<const LawValues> laws;
    std::vector<double> residual;
    std::size_t tangent = 0;  ///< its stamp (System::use_tangent); 0: none yet
  };

  Known& at_place(const Iterate& at);
  const std::vector<double>& residual_at(const Iterate& at);
  ControlPoint control_point(const Iterate& at);
  void solve_base(const Iterate& at, std::span<double> column);
  Verdict verdict(bool is_equilibrium, double control, int iterations);
  bool meets_control(double control);

  System& system_;
  const ControlEquation& control_;
  double step_;
  NewtonParameters parameters_;
  Aim aim_;
  Known known_;
  PiecesWatch pieces_;
  double relative_ = 0;
  bool was_equilibrium_ = false;
  std::optional<double> control_before_;  ///< |N| of the last iteration if that was an equilibrium
};

}  // namespace dda
