#include "continuation/solve/trilinos_module.hpp"

#include "framework/base/loaded.hpp"

namespace dda {

const TrilinosModule& trilinos() {
  using Module = const TrilinosModule* (*)();
  static const auto module =
      reinterpret_cast<Module>(symbol_of(module_file(DDA_TRILINOS_MODULE), "dda_trilinos"));
  return *module();
}

Eigenmodes krylov_schur(const EigenProblem& problem, const Search& search) {
  return trilinos().krylov_schur(problem, search);
}

}  // namespace dda
