#include "continuation/control/control.hpp"
#include "continuation/detour/increment/load_solver.hpp"
#include "continuation/linear/direct/direct_solver.hpp"

namespace dda {

DirectSolverFamily& direct_solvers() {
  static DirectSolverFamily family("linear", "How linear systems are factorised and solved.");
  return family;
}

ControlFamily& controls() {
  static ControlFamily family("control", "What is prescribed along the path.");
  return family;
}

LoadSolverFamily& load_solvers() {
  static LoadSolverFamily family("solver", "How a load increment finds its equilibrium.");
  return family;
}

}  // namespace dda
