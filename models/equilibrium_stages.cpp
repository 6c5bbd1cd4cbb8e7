// Stages that begin while a path is followed.
#include <algorithm>
#include <cassert>

#include "models/equilibrium.hpp"
#include "models/loading.hpp"

namespace dda {

void Equilibrium::fit_stages() {
  for (auto* stages : {&stages_, &later_stages_})
    for (Loading& stage : *stages)
      for (auto* force : {&stage.dead, &stage.reference, &stage.dead_work, &stage.reference_work})
        force->resize(num_unknowns(), 0.0);
}

void Equilibrium::hold(const Body& body, const ModelParameters& model, double load_factor) {
  assert(!later_stages_.empty());
  history_.held_load_factors.push_back(load_factor);
  Findings none;
  StageLoadings made = make_stages({body, model, set_, all_supports_, supports_, removed_, history_},
                                   make_loads(body, model, none), none);
  std::ranges::move(made.begun, stages_.begin());
  later_stages_ = std::move(made.later);
  fit_stages();
}

void Equilibrium::append_stage(const Body& body, const ModelParameters& model) {
  Findings findings;
  const LoadProgramme programme = make_loads(body, model, findings);
  if (programme.driven.size() != driven_.size() || !programme.stages.back().removed.empty())
    findings.add(model.stages.back().where,
                 "a stage that comes while a path is followed takes no support away, and drives what an "
                 "earlier stage has driven");
  findings.throw_if_any();
  StageLoadings made =
      make_stages({body, model, set_, all_supports_, supports_, removed_, history_}, programme, findings);
  findings.throw_if_any();
  later_stages_ = std::move(made.later);
  fit_stages();
}

}  // namespace dda
