#include "continuation/modules/anasazi/krylov_schur.hpp"
#include "continuation/modules/loca/loca_steps.hpp"
#include "continuation/modules/trilinos_session.hpp"
#include "continuation/solve/trilinos_module.hpp"

/// What continuation/solve/trilinos_module.cpp loads.
extern "C" const dda::TrilinosModule* dda_trilinos() {
  static const dda::TrilinosSession session;
  static constexpr dda::TrilinosModule module{.controlled_step = dda::loca_controlled_step,
                                              .arc_length_step = dda::loca_arc_length_step,
                                              .krylov_schur = dda::anasazi_krylov_schur};
  return &module;
}
