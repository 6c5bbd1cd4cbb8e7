#include "continuation/increment/load_solver.hpp"
#include "continuation/linear/direct_solver.hpp"
#include "continuation/strategy/driver.hpp"

namespace dda {

DirectSolverFamily& direct_solvers() {
  static DirectSolverFamily family("linear", "How linear systems are factorised and solved.");
  return family;
}

DriverFamily& drivers() {
  static DriverFamily family("control", "What is prescribed along the path.");
  return family;
}

LoadSolverFamily& load_solvers() {
  static LoadSolverFamily family("solver", "How a load increment finds its equilibrium.");
  return family;
}

}  // namespace dda
