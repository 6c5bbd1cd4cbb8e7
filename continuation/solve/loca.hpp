#pragma once

#include <memory>

#include "continuation/solve/equations.hpp"
#include "framework/deck/node.hpp"

namespace dda {

/// How NOX goes from one iterate to the next.
enum class Method {
  newton,       ///< Newton's direction in full
  line_search,  ///< Newton's direction, shortened until the residual falls
  walk          ///< to the end of a finite walk (WalkedEquations)
};

/// A solve that is asked of LOCA.
struct Solve {
  Equations& equations;
  Iterate guess;
  double step = 0;  ///< s of the control at its end
  Method method = Method::newton;
};

/// What it came to.
struct Solved {
  bool converged = false;
  std::vector<double> x;
  double load_factor = 0;
  int iterations = 0;
  std::string reason = {};  ///< why it failed
};

/// One LOCA::Stepper over all steps of a path in some unknowns: natural continuation in the abstract
/// parameter s of the controls, closed by the control as a LOCA constraint with unknown λ.
///
/// Each solve is a try of its next step, which NOX converges from the guess; the stepper refuses it when
/// another follows that is not accepted, and counts those that are.
class LocaStepper {
 public:
  virtual ~LocaStepper() = default;
  virtual Solved solve(const Solve& wanted) = 0;
  /// The next point of the path is here, where a solve has converged.
  virtual void accept(const Iterate& at) = 0;
  /// Accepted steps, as LOCA counts them.
  virtual int num_steps() const = 0;
};

/// The deck's sublists for them.
struct LocaLists {
  Node nox, loca;
};

/// A stepper, from a module that is loaded when it is first asked for. Throws std::runtime_error with the
/// loader's words, and what NOX or LOCA say to the lists.
std::unique_ptr<LocaStepper> make_loca_stepper(const LocaLists& lists);

}  // namespace dda
