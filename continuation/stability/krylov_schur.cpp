#include "continuation/stability/krylov_schur.hpp"

#include "framework/base/loaded.hpp"

namespace dda {

Eigenmodes krylov_schur(const EigenProblem& problem, const Search& search) {
  using Find = void (*)(const EigenProblem&, const Search&, Eigenmodes&);
  static const auto find =
      reinterpret_cast<Find>(symbol_of(module_file("dda_trilinos.so"), "dda_krylov_schur"));
  Eigenmodes out;
  find(problem, search, out);
  return out;
}

}  // namespace dda
