#include "verification/stepped.hpp"

namespace dda::verification {

Stepped::Stepped(const std::string& deck_text, const MultiplierParameters& multipliers)
    : structure_(deck_text),
      system_(structure_.equilibrium, direct_solvers().choose("cholmod"), LinearSystem::Update::low_rank),
      stepper_(system_, {.newton = {}, .multipliers = multipliers}),
      state_{std::vector<double>(structure_.equilibrium.num_unknowns(), 0.0), 0, system_.multipliers()} {}

Attempt Stepped::to(double load_factor) {
  if ((load_factor - state_.load_factor) * last_change_ < 0) turn_back();
  const auto control = make_gauge_equation({.rows = {}, .per_load_factor = 1});
  State guess = state_;
  guess.load_factor = load_factor;
  Attempt out = stepper_.find({state_, *control, load_factor - state_.load_factor, guess});
  if (!out.converged) {
    system_.set_multipliers(state_.multipliers);
    return out;
  }
  last_change_ = load_factor - state_.load_factor;
  state_ = out.state;
  system_.set_multipliers(state_.multipliers);
  system_.set_history(system_.next_history(state_));
  system_.remember_force_level(state_.d);
  return out;
}

void Stepped::turn_back() {
  std::vector<History> history = system_.history();
  for (History& h : history) h.loading = h.sliding = false;
  system_.set_history(std::move(history));
}

void Stepped::next_stage() {
  system_.set_stage(++stage_);
  state_.load_factor = last_change_ = 0;
}

double Stepped::gauge(const std::string& name) const {
  for (const NamedGauge& gauge : system_.loading().gauges)
    if (gauge.name == name) return state_.value(gauge.functional);
  throw std::out_of_range(name);
}

double Stepped::reaction(const std::string& name) const {
  return state_.value(system_.loading().reactions.at(name));
}

Vec2 Stepped::traction(std::size_t point) const { return laws().traction[point]; }

Vec2 Stepped::force() const {
  const LawValues values = laws();
  Vec2 out = Vec2::Zero();
  for (std::size_t p = 0; p < values.traction.size(); ++p)
    out += structure_.equilibrium.point(p).weight * values.traction[p];
  return out;
}

Vec2 Stepped::jump(std::size_t point) const {
  const InterfacePoint& at = structure_.equilibrium.point(point);
  const auto of = [&](BlockId id) { return Eigen::Map<const Vec6>(state_.d.data() + 6 * id.value()); };
  const auto& blocks = structure_.assembly.blocks;
  const Vec2 first = displacement_rows(at.x - blocks[at.first.value()].moments.centroid) * of(at.first);
  const Vec2 second = displacement_rows(at.x - blocks[at.second.value()].moments.centroid) * of(at.second);
  const Vec2 g = second - first, s(-at.normal.y(), at.normal.x());
  return {at.normal.dot(g), s.dot(g)};
}

}  // namespace dda::verification
