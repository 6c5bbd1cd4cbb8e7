// Stages that begin while a path is followed, and the supports that they put in and take away.
#include <algorithm>
#include <cassert>

#include "models/equilibrium/equilibrium.hpp"
#include "models/equilibrium/loading.hpp"

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

std::span<const ChangingSpring> Equilibrium::due(const std::vector<ChangingSpring>& springs,
                                                 std::size_t num_done) const {
  const auto end = std::ranges::find_if(
      springs, [this](const ChangingSpring& spring) { return spring.stage > present_stage(); });
  return {springs.begin() + static_cast<std::ptrdiff_t>(num_done), end};
}

std::vector<Spring> Equilibrium::supports_after(std::size_t num_added, std::size_t num_removed) const {
  std::vector<bool> is_there(all_supports_.size(), true);
  for (std::size_t i = num_added; i < added_.size(); ++i) is_there[added_[i].spring] = false;
  for (std::size_t i = 0; i < num_removed; ++i) is_there[removed_[i].spring] = false;
  std::vector<Spring> out;
  for (std::size_t i = 0; i < all_supports_.size(); ++i)
    if (is_there[i]) out.push_back(all_supports_[i]);
  return out;
}

SupportChange Equilibrium::support_change(std::span<const double> d) const {
  SupportChange out;
  for (const ChangingSpring& added : springs_to_add())
    out.rest.push_back(all_supports_[added.spring].displacement.value(d, 0));
  for (const ChangingSpring& removed : springs_to_remove()) {
    const Spring& spring = all_supports_[removed.spring];
    out.borne.push_back(spring.force(d));
    out.energy += out.borne.back() * out.borne.back() / (2 * spring.stiffness);
  }
  return out;
}

void Equilibrium::change_supports(const Body& body, const ModelParameters& model,
                                  const SupportChange& change) {
  history_.rest.insert(history_.rest.end(), change.rest.begin(), change.rest.end());
  history_.borne.insert(history_.borne.end(), change.borne.begin(), change.borne.end());
  remake(body, model);
}

/// Those that are there from the beginning, and those that are there in each stage.
void Equilibrium::check_supports(const Body& body, const ModelParameters& model, Findings& findings) const {
  const auto up_to = [](std::size_t stage) {
    return [stage](const ChangingSpring& spring) { return spring.stage <= stage; };
  };
  const std::vector<StageParameters> stages = model.loaded_stages();
  std::size_t added_before = 0, removed_before = 0;
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const auto num_added = static_cast<std::size_t>(std::ranges::count_if(added_, up_to(s))),
               num_removed = static_cast<std::size_t>(std::ranges::count_if(removed_, up_to(s)));
    if (s > 0 && num_added == added_before && num_removed == removed_before) continue;
    std::vector<Spring> springs = supports_after(num_added, num_removed), planes = springs_of_planes(body);
    springs.insert(springs.end(), planes.begin(), planes.end());
    springs.insert(springs.end(), driven_.begin(), driven_.end());
    check_rigid_motions(body, springs, s == 0 ? model.where : stages[s].where, findings);
    added_before = num_added;
    removed_before = num_removed;
  }
}

}  // namespace dda
