#include "models/equilibrium/loading.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "framework/base/suggestion.hpp"
#include "models/load/driven_springs.hpp"
#include "models/load/eigenstress.hpp"

namespace dda {
namespace {

using Vector = std::vector<double>;

void add_scaled(double scale, const Vector& from, Vector& to) {
  to.resize(from.size(), 0.0);
  for (std::size_t i = 0; i < from.size(); ++i) to[i] += scale * from[i];
}

/// r = p̄ (δ_dead + δ_ref λ − l·u).
Functional force_of(const Spring& spring, double dead, double reference) {
  Functional out;
  out.add(-spring.stiffness, spring.displacement);
  out.constant = spring.stiffness * dead;
  out.per_load_factor = spring.stiffness * reference;
  return out;
}

/// Builds the Loading of each stage in turn.
class StageMaker {
 public:
  StageMaker(const Structure& structure, const LoadProgramme& programme, Findings& findings)
      : body_(structure.body),
        model_(structure.model),
        interfaces_(structure.interfaces),
        supports_(structure.supports),
        all_(structure.all_supports),
        removed_(structure.removed),
        held_(structure.history.held_load_factors),
        borne_(structure.history.borne),
        programme_(programme),
        stages_(model_.loaded_stages()),
        num_dead_(model_.num_dead_stages()),
        findings_(findings) {
    const std::size_t n = block_unknowns * body_.num_nodes();
    so_far_.dead.assign(n, 0.0);
    so_far_.dead_work.assign(n, 0.0);
    driven_so_far_.assign(programme.driven.size(), 0.0);
    for (const Spring& spring : supports_)
      if (spring.rest != 0) spring.displacement.add_gradient(spring.stiffness * spring.rest, so_far_.dead);
  }

  StageLoadings make() {
    if (programme_.stages.empty()) return {{no_stage()}, {}};
    StageLoadings out;
    bool are_forces = true;
    for (std::size_t s = 0; s < programme_.stages.size(); ++s) {
      Loading now = stage(s);
      are_forces = are_forces && (s < num_dead_ || now.load_is_force);
      if (s < present()) absorb(now, s < num_dead_ ? 1 : held_[s - num_dead_]);
      if (s < num_dead_ || s == present())
        out.begun.push_back(std::move(now));
      else if (s > present())
        out.later.push_back(std::move(now));
    }
    for (auto* stages : {&out.begun, &out.later})
      for (Loading& stage : *stages) stage.all_are_forces = are_forces;
    return out;
  }

 private:
  /// The stage that is followed.
  std::size_t present() const { return num_dead_ + held_.size(); }

  Loading no_stage() {
    Loading out = so_far_;
    add_reactions(out, {});
    add_gauges(out, true);
    return out;
  }

  Loading stage(std::size_t index) {
    const StageLoads& loads = programme_.stages[index];
    add_borne(index, 1, so_far_.dead, so_far_.dead_work);
    Loading out = so_far_;
    out.name = stages_[index].name;
    out.reference = out.reference_work = loads.force;
    if (!loads.initial_stress.empty()) {
      const StressOffset offset = stress_offset(body_, interfaces_, loads.initial_stress);
      out.reference_offset = offset.openings;
      out.reference_stress = loads.initial_stress;
      out.reference_out_of_plane = loads.out_of_plane;
      add_scaled(1, offset.force, out.reference);
      add_scaled(1, offset.force, out.reference_work);
    }
    Vector reference(programme_.driven.size(), 0.0);
    for (const DrivenSpring& driven : loads.driven) {
      const Spring& spring = programme_.driven[driven.spring];
      const double prescribed = driven.sense * driven.prescribed;
      reference[driven.spring] = prescribed;
      spring.displacement.add_gradient(spring.stiffness * prescribed, out.reference);
    }
    add_borne(index, -1, out.reference, out.reference_work);
    add_reactions(out, reference);
    add_fading_reactions(index, out);
    out.load_is_force = has_resultant(loads, resultant_of_borne(index));
    out.load = load_gauge(out, loads, resultant_of_borne(index));
    add_gauges(out, index == present());
    driven_now_ = std::move(reference);
    return out;
  }

  void add_reactions(Loading& out, const Vector& driven_reference) {
    for (const Spring& spring : all_)
      if (!spring.reaction.empty())
        out.reactions[spring.reaction].is_moment = spring.turns;  // 0 of those that are not there
    for (const Spring& spring : supports_)
      if (!spring.reaction.empty()) out.reactions[spring.reaction].add(1, force_of(spring, spring.rest, 0));
    for (std::size_t i = 0; i < programme_.driven.size(); ++i) {
      const Spring& spring = programme_.driven[i];
      const Functional force = force_of(spring, driven_so_far_[i], driven_reference[i]);
      out.reactions[spring.reaction].add(1, force);
      out.driven.push_back({force, spring.displacement});
    }
  }

  /// The share of the forces that supports bore which the stage takes away.
  void add_borne(std::size_t stage, double share, Vector& force, Vector& work) const {
    for (std::size_t i = 0; i < borne_.size(); ++i)
      if (removed_[i].stage == stage)
        for (Vector* to : {&force, &work})
          all_[removed_[i].spring].displacement.add_gradient(share * borne_[i], *to);
  }

  /// (1 − λ) r of what is being taken away, and what is left of earlier ones.
  void add_fading_reactions(std::size_t stage, Loading& out) const {
    for (std::size_t i = 0; i < borne_.size(); ++i) {
      const std::size_t of = removed_[i].stage;
      const std::string& name = all_[removed_[i].spring].reaction;
      if (name.empty() || of > stage) continue;
      Functional& reaction = out.reactions[name];
      const std::size_t followed = of - num_dead_;
      reaction.constant += borne_[i] * (followed < held_.size() ? 1 - held_[followed] : 1);
      if (of == stage) reaction.per_load_factor -= borne_[i];
    }
  }

  double resultant_of_borne(std::size_t stage) const {
    double out = 0;
    for (std::size_t i = 0; i < borne_.size(); ++i)
      if (removed_[i].stage == stage) out += std::abs(borne_[i]);
    return out;
  }

  /// Whether the loads of a stage are more than couples and what only stretches and bends blocks: more than rounding.
  bool has_resultant(const StageLoads& loads, double borne) const {
    constexpr double rounding = 1e-12;
    double all = 0;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
      const Eigen::Map<const Vec6> f(loads.force.data() + block_unknowns * b);
      all += f.head<2>().norm() + f.tail<4>().norm() / body_.size(BlockId{b});
    }
    return !loads.driven.empty() || loads.resultant + borne > rounding * all;
  }

  /// λ Σ|force|; with driven springs the sum of their reactions; λ itself when the loads have no resultant.
  Functional load_gauge(const Loading& out, const StageLoads& loads, double borne) const {
    const double resultant = loads.resultant + borne;
    if (loads.driven.empty()) return {.rows = {}, .per_load_factor = out.load_is_force ? resultant : 1.0};
    Functional sum;
    for (const DrivenSpring& driven : loads.driven) sum.add(driven.sense, out.driven[driven.spring].force);
    return sum;
  }

  void add_gauges(Loading& out, bool report) {
    for (const auto& [name, choice] : model_.gauge_names) {
      try {
        const auto gauge = choice.make();
        const GaugeSources sources{body_,
                                   out.reactions,
                                   out.dead_stress,
                                   out.reference_stress,
                                   out.dead_out_of_plane,
                                   out.reference_out_of_plane};
        out.gauges.push_back({name, gauge->functional(sources), gauge->dimension_of(sources)});
      } catch (const InputError& error) {
        if (report) findings_.add(error);
      }
    }
  }

  /// The stage that was made last is dead in the next, at a share of its full value.
  void absorb(const Loading& stage, double share) {
    add_scaled(share, driven_now_, driven_so_far_);
    add_scaled(share, stage.reference, so_far_.dead);
    add_scaled(share, stage.reference_work, so_far_.dead_work);
    if (!stage.reference_offset.empty()) add_scaled(share, stage.reference_offset, so_far_.dead_offset);
    if (!stage.reference_out_of_plane.empty())
      add_scaled(share, stage.reference_out_of_plane, so_far_.dead_out_of_plane);
    if (stage.reference_stress.empty()) return;
    so_far_.dead_stress.resize(stage.reference_stress.size(), Vec3::Zero());
    for (std::size_t b = 0; b < stage.reference_stress.size(); ++b)
      so_far_.dead_stress[b] += share * stage.reference_stress[b];
  }

  const Body& body_;
  const ModelParameters& model_;
  const InterfaceSet& interfaces_;
  const std::vector<Spring>& supports_;
  const std::vector<Spring>& all_;
  const std::vector<ChangingSpring>& removed_;
  const Vector &held_, &borne_;
  const LoadProgramme& programme_;
  const std::vector<StageParameters> stages_;
  const std::size_t num_dead_;
  Findings& findings_;
  Loading so_far_;
  Vector driven_so_far_, driven_now_;  ///< far ends of the driven springs [L]
};

}  // namespace

StressOffset stress_offset(const Body& body, const InterfaceSet& set, const std::vector<Vec3>& stress) {
  StressOffset out{Vector(2 * set.num_active, 0.0), Vector(block_unknowns * body.num_nodes(), 0.0)};
  for (std::size_t p = 0; p < set.points.size(); ++p) {
    const InterfacePoint& point = set.points[p];
    if (point.rows.first_stress.isZero() && point.rows.second_stress.isZero()) continue;
    // The weights of {σ}n are those of the rows: S_i = w_i N C_i E.
    const auto traction = [&](const Mat26& rows, BlockId id) -> Vec2 {
      Vec3 here = Vec3::Zero();
      for (const auto& [place, share] : eigenstress_at(body, id, point.x)) here += share * stress[place];
      return rows.rightCols<3>() * body.material(id).stiffness().inverse() * here;
    };
    const Vec2 mean =
        traction(point.rows.first_stress, point.first) + traction(point.rows.second_stress, point.second);
    const Vec2 offset = mean.cwiseQuotient(point.trial_stiffness());
    // ψ(B d + q0) − ½ {σ}n P⁻¹ {σ}n: a bond contributes −Bᵀ W D0 q0, every point +Sᵀ W P⁻¹ {σ0}n.
    point.for_each_stress([&](BlockId node, const Mat26& rows) {
      Eigen::Map<Vec6>(out.force.data() + 6 * node.value()) += point.weight * rows.transpose() * offset;
    });
    if (p < set.num_active) {
      Eigen::Map<Vec2>(out.openings.data() + 2 * p) = offset;
    } else {
      const Vec2 traction_of_offset = point.intact_stiffness().cwiseProduct(offset);
      point.for_each_part([&](BlockId node, const Mat26& rows) {
        Eigen::Map<Vec6>(out.force.data() + 6 * node.value()) -=
            point.weight * rows.transpose() * traction_of_offset;
      });
    }
  }
  return out;
}

std::vector<ChangingSpring> LoadProgramme::removed(const std::vector<Spring>& supports) const {
  std::vector<ChangingSpring> out;
  for (std::size_t s = 0; s < stages.size(); ++s)
    for (const RemovedSupport& removed : stages[s].removed)
      add_changing_springs(supports, removed.name, s, out);
  return out;
}

namespace {

/// What is wrong with taking a support away in a stage; "" where nothing is.
std::string wrong_removal(const ModelParameters& model, const std::vector<StageParameters>& stages,
                          std::size_t stage, const std::string& name) {
  const auto support = std::ranges::find(model.supports, name, [](const auto& entry) { return entry.first; });
  if (support == model.supports.end()) {
    std::vector<std::string> names;
    for (const auto& [known, parameters] : model.supports) names.push_back(known);
    return "unknown support '" + name + "'" + suggest(name, names);
  }
  if (stage == 0)
    return "support '" + name + "' bears nothing before the first stage; leave it out of `supports`";
  const auto end = stages[stage].until.find("load_factor");
  if (end == stages[stage].until.end() || end->second <= 0 || end->second > 1)
    return "what support '" + name +
           "' bears is let go by the load factor, of which 1 leaves nothing: the stage needs `until: "
           "{load_factor: 1}`";
  const std::span<const StageParameters> before(stages.data(), stage);
  const std::string& from = support->second.from;
  if (!from.empty() && std::ranges::find(before, from, &StageParameters::name) == before.end())
    return "support '" + name + "' is put in by no stage before this one";
  return "";
}

/// A support is taken away once, by a stage whose loads a load factor multiplies, and when there is something that it bears.
void check_removals(const ModelParameters& model, const LoadProgramme& programme, Findings& findings) {
  const std::vector<StageParameters> stages = model.loaded_stages();
  std::set<std::string> gone;
  for (std::size_t s = 0; s < programme.stages.size(); ++s)
    for (const auto& [name, where] : programme.stages[s].removed) {
      if (!gone.insert(name).second)
        findings.add(where, "support '" + name + "' has been taken away before");
      else if (const std::string wrong = wrong_removal(model, stages, s, name); !wrong.empty())
        findings.add(where, wrong);
    }
}

}  // namespace

LoadProgramme make_loads(const Body& body, const ModelParameters& model, Findings& findings) {
  LoadProgramme out;
  const double stiffness = model.support_stiffness * body.largest_modulus() * body.thickness;
  DrivenSprings driven;
  for (const StageParameters& stage : model.loaded_stages()) {
    StageLoads loads;
    loads.force.assign(block_unknowns * body.num_nodes(), 0.0);
    for (const LoadChoice& load : stage.loads) {
      try {
        const std::size_t before = loads.driven.size();
        load.make()->add_to(loads, body);
        driven.place(out.stages.size(), std::span(loads.driven).subspan(before));
      } catch (const InputError& error) {
        findings.add(error);
      }
    }
    out.stages.push_back(std::move(loads));
  }
  for (const DrivenSpring& spring : driven.springs())
    out.driven.push_back({spring.name, spring.displacement, spring.share * stiffness});
  check_removals(model, out, findings);
  return out;
}

void check_driven(const LoadProgramme& programme, const std::vector<Spring>& supports, Findings& findings) {
  for (const StageLoads& stage : programme.stages)
    for (const DrivenSpring& driven : stage.driven)
      for (const Spring& support : supports)
        if (sense_of(support.displacement, driven.displacement) != 0) {
          findings.add(driven.where, fmt::format("support '{}' holds what this load drives along the same "
                                                 "direction; take that out of the support",
                                                 support.support));
          return;
        }
}

StageLoadings make_stages(const Structure& structure, const LoadProgramme& programme, Findings& findings) {
  return StageMaker(structure, programme, findings).make();
}

}  // namespace dda
