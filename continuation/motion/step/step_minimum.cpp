#include "continuation/motion/step/step_minimum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/motion/step/friction_bounds.hpp"

namespace dda {
namespace {

using Vector = Eigen::VectorXd;

Poses advanced(const Poses& z, const Poses& dz, double share) {
  Poses out(z.size());
  for (std::size_t b = 0; b < z.size(); ++b) out[b] = z[b] + share * dz[b];
  return out;
}

/// So many springs may change in a direction that they cost about as much as the factorisation: half a solution each of a
/// plane graph, n log n beside n^(3/2).
Eigen::Index as_dear_as_factor(Eigen::Index unknowns) {
  return static_cast<Eigen::Index>(1.5 * std::sqrt(static_cast<double>(unknowns)));
}

}  // namespace

MotionStep StepMinimum::solve(const StepStart& from, const Inertia& inertia) {
  const Poses& start = from.poses;
  scale_ = force_scale(scene_, start, inertia);
  potential_.begin(start);
  potential_.set_sliders({});
  MotionStep out{.poses = start, .forces = {}, .meeting = {}, .contacts = {}, .slides = {}, .failure = {}};
  FrictionBounds bounds;
  for (int pass = 0; out.converged(); ++pass) {
    Rubbing rubbing{sliders_at(out.poses, from.sliders, pass == 0), potential_.rubbing(out.poses)};
    const bool is_free = rubbing.empty();  // of friction: there is nothing to settle
    if (pass > 0 && is_free && !potential_.has_friction()) break;
    std::vector<FrictionBound> asked = rubbing.bounds(potential_.bonds());
    const double change = pass > 0 ? bounds.change(asked) : 1;
    const bool is_settled = change <= tolerances_.friction_change;
    if (pass == tolerances_.most_passes && !is_settled) {
      out.failure =
          fmt::format("friction has not settled: normal forces change by {:.1e} of their sum", change);
      break;
    }
    if (!is_settled) bounds.relax(asked);
    rubbing.set_bounds(asked);
    potential_.set_sliders(std::move(rubbing.sliders));
    potential_.set_rubbing(rubbing.bonds);
    rounding_ = potential_.rounding(out.poses, inertia.per_square_time);
    if (pass == 0) out.poses = predicted(start, inertia);
    const Minimised found =
        minimise(out.poses, inertia, is_settled || is_free ? tolerances_.tolerance : tolerances_.loose);
    out.iterations += found.iterations;
    out.failure = found.failure;
    if (is_settled) break;
  }
  if (out.converged()) tell(start, out);
  return out;
}

/// Forces at the end, and what contacts and sliders keep and have spent.
void StepMinimum::tell(const Poses& start, MotionStep& out) const {
  out.forces = potential_.gradient(out.poses);
  out.meeting = Vector::Zero(out.forces.size());
  potential_.add_meeting_forces(out.poses, out.meeting);
  for (const Slider& slider : potential_.sliders()) {
    const double u = slider.reached(start, out.poses);
    if (std::abs(u) > (1 + 1e-9) * std::abs(slider.kept(u)))
      out.slides.push_back({.meeting = slider.meeting,
                            .at_start = slider.stiffness * slider.start,
                            .force = slider.force(u),
                            .slipped = u - slider.kept(u)});
    out.contacts.set(slider.meeting.key, {slider.kept(u), 0});
  }
  const std::vector<Meeting> meetings = potential_.meetings(out.poses);
  out.num_meetings = meetings.size();
  for (const Meeting& meeting : meetings) {
    SliderMemory::Kept kept = out.contacts.of(meeting.key);
    kept.force = response_of(scene_.meeting, meeting).force;
    out.contacts.set(meeting.key, kept);
  }
}

StoredEnergies StepMinimum::stored(const std::vector<BodyCourse>& at) const {
  Poses poses;
  for (const BodyCourse& course : at) poses.push_back(course.now);
  return potential_.stored(poses);
}

/// Where the step is looked for first: the lowest of the start and of what is free for cores on the ways of flight and of
/// the last accelerations.
Poses StepMinimum::predicted(const Poses& start, const Inertia& inertia) {
  Poses lowest = start;
  double least = objective(start, inertia);
  for (const Poses* end : {&inertia.likely, &inertia.flight}) {
    Poses way(start.size(), Pose::Zero());
    for (std::size_t b = 0; b < start.size(); ++b)
      if (!scene_.bodies[b].is_held) way[b] = (*end)[b] - start[b];
    potential_.set_candidates(potential_.all_candidates(start, advanced(start, way, 1)));
    Poses there = advanced(start, way, std::min(bearable_share(way), potential_.free_share(start, way)));
    const double value = objective(there, inertia);
    if (!(value < least)) continue;
    least = value;
    lowest = std::move(there);
  }
  potential_.set_candidates(potential_.all_candidates(lowest, lowest));
  return lowest;
}

/// What the step makes least.
double StepMinimum::objective(const Poses& z, const Inertia& inertia) const {
  double sum = potential_.value(z);
  for (std::size_t b = 0; b < z.size(); ++b)
    if (!scene_.bodies[b].is_held)
      sum += inertia.per_square_time *
             (z[b] - inertia.flight[b]).dot(scene_.bodies[b].block.times_mass(z[b] - inertia.flight[b])) / 2;
  return sum;
}

Vector StepMinimum::gradient(const Poses& z, const Inertia& inertia) const {
  Vector out = potential_.gradient(z);
  for (std::size_t b = 0; b < z.size(); ++b) {
    if (scene_.bodies[b].is_held)
      of_body(out, b).setZero();
    else
      of_body(out, b) +=
          inertia.per_square_time * scene_.bodies[b].block.times_mass(z[b] - inertia.flight[b]);
  }
  return out;
}

/// What is left to go for bodies that are driven; empty where all are there.
Poses StepMinimum::ways_of_held(const Poses& z, const Inertia& inertia) const {
  Poses out;
  for (std::size_t b = 0; b < z.size(); ++b) {
    if (!scene_.bodies[b].is_held || z[b] == inertia.flight[b]) continue;
    if (out.empty()) out.assign(z.size(), Pose::Zero());
    out[b] = inertia.flight[b] - z[b];
  }
  return out;
}

/// Newton's direction, in which driven bodies go all the way; empty where the curvature is not positive definite.
Poses StepMinimum::direction(const Poses& z, const Inertia& inertia, const Vector& gradient) {
  Poses dz = ways_of_held(z, inertia);
  for (const auto softening : {Potential::Softening::tangent, Potential::Softening::secant}) {
    const Potential::Curvature k = potential_.curvature(z, inertia.per_square_time, softening, dz);
    if (!factor(k)) continue;
    Vector right = -k.pull;
    for (std::size_t b = 0; b < z.size(); ++b)
      if (const int row = potential_.row_of(b); row >= 0) right.segment<6>(6 * row) -= of_body(gradient, b);
    const Vector dv = dz.empty()
                          ? ClampedMinimum(factor_, k.springs, as_dear_as_factor(right.size())).solve(right)
                          : factor_.solve(right);
    if (!dv.allFinite() || !(dv.dot(right) > 0)) continue;
    dz.resize(z.size(), Pose::Zero());
    for (std::size_t b = 0; b < z.size(); ++b)
      if (const int row = potential_.row_of(b); row >= 0) dz[b] = dv.segment<6>(6 * row);
    return dz;
  }
  return {};
}

/// Newton's method, until so much of the forces is left.
StepMinimum::Minimised StepMinimum::minimise(Poses& z, const Inertia& inertia, double tolerance) {
  Minimised out;
  Vector g = gradient(z, inertia);
  for (;; ++out.iterations) {
    const Unbalanced most = unbalanced(scene_, g, rounding_);
    const double left = scale_ > 0 ? most.force / scale_ : most.force;
    const bool is_driven = !ways_of_held(z, inertia).empty();
    if (left <= tolerance && !is_driven) return out;
    if (out.iterations == tolerances_.most_iterations || !std::isfinite(left)) {
      out.failure = fmt::format("no minimum in {} iterations: {:.1e} of the forces is left at body {}",
                                out.iterations, left, most.body);
      return out;
    }
    const Poses dz = direction(z, inertia, g);
    if (dz.empty()) {
      out.failure = "the curvature is not positive definite";
      return out;
    }
    potential_.set_candidates(potential_.all_candidates(z, advanced(z, dz, 1)));
    const double free = std::min(bearable_share(dz), potential_.free_share(z, dz));
    if (is_driven) {
      z = advanced(z, dz, free);
      for (std::size_t b = 0; free == 1 && b < z.size(); ++b)
        if (scene_.bodies[b].is_held) z[b] = inertia.flight[b];
      g = gradient(z, inertia);
      continue;
    }
    Found found = line_search(z, dz, inertia, {slope_along(g, dz), free});
    z = advanced(z, dz, found.share);
    g = std::move(found.gradient);
  }
}

/// The share of dz that turns and strains no body by more than a tenth, nor moves any that may meet another on the way by more
/// than its size: beyond, the curvatures tell nothing.
double StepMinimum::bearable_share(const Poses& dz) const {
  constexpr double most = 0.1;
  double out = 1;
  for (std::size_t b = 0; b < dz.size(); ++b)
    out = std::min(out, most / std::max(most, dz[b].tail<4>().norm()));
  const auto keep_near = [&](std::size_t b) {
    out = std::min(out, scene_.bodies[b].size / std::max(scene_.bodies[b].size, dz[b].head<2>().norm()));
  };
  for (const auto& [i, j] : potential_.candidates()) {
    keep_near(i);
    keep_near(j);
  }
  return out;
}

/// Whether it is positive definite. The order of elimination is kept as long as the same bodies may meet.
bool StepMinimum::factor(const Potential::Curvature& curvature) {
  if (curvature.has_new_pattern || !is_analysed_) {
    factor_.analyse(curvature.matrix);
    is_analysed_ = true;
  }
  return factor_.factorise(curvature.matrix);
}

/// The slope along a way, without bodies on which what is left is rounding: next to stiff supports that hides all else.
double StepMinimum::slope_along(const Vector& gradient, const Poses& way) const {
  double out = 0;
  for (std::size_t b = 0; b < way.size(); ++b)
    if (const auto g = of_body(gradient, b); left_of(g, scene_.bodies[b].size) > rounding_[b])
      out += g.dot(way[b]);
  return out;
}

/// Where the slope along dz has fallen to a fifth, by bisection and the Illinois rule; as far as cores are free where it
/// still leads down there.
StepMinimum::Found StepMinimum::line_search(const Poses& z, const Poses& dz, const Inertia& inertia,
                                            const Descent& descent) const {
  constexpr double flat = 0.2;
  constexpr int most = 40;
  Found out{descent.free, {}};
  const auto slope_at = [&](double a) {
    out = {a, gradient(advanced(z, dz, a), inertia)};
    return slope_along(out.gradient, dz);
  };
  const double first = descent.slope;
  double low = 0, high = descent.free, at_low = first, at_high = slope_at(high);
  if (!(first < 0 && at_high > flat * std::abs(first))) return out;
  for (int i = 0, side = 0; i < most; ++i) {
    const double now =
        slope_at(i % 3 == 2 ? (low + high) / 2 : low - at_low * (high - low) / (at_high - at_low));
    if (std::abs(now) <= flat * std::abs(first)) return out;
    (now > 0 ? high : low) = out.share;
    (now > 0 ? at_high : at_low) = now;
    if (side * now > 0) (now > 0 ? at_low : at_high) /= 2;
    side = now > 0 ? 1 : -1;
  }
  if (low > 0) slope_at(low);
  return out;
}

std::vector<Slider> StepMinimum::sliders_at(const Poses& z, const SliderMemory& memory,
                                            bool uses_memory) const {
  const MeetingRules& rules = scene_.meeting;
  std::vector<Slider> out;
  for (const Meeting& meeting : potential_.meetings(z)) {
    const double friction = rules.friction(meeting.key.body, meeting.key.other);
    if (friction <= 0) continue;
    const SliderMemory::Kept kept = memory.of(meeting.key);
    const double now = response_of(rules, meeting).force;
    out.push_back({.meeting = meeting,
                   .start = kept.slip,
                   .stiffness = rules.shear_stiffness * meeting.stiffness,
                   .bound = friction * (uses_memory && kept.force > 0 ? kept.force : now)});
  }
  return out;
}

}  // namespace dda
