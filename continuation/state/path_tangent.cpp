// Tangents by which a path goes on: those of the laws, with the joints' own stiffness where multipliers are
// iterated, with a residual stiffness where bodies move freely on each other.
#include <Eigen/LU>
#include <algorithm>

#include "continuation/state/residual_stiffness.hpp"
#include "continuation/state/system.hpp"
#include "models/equilibrium/stiffness_parts.hpp"

namespace dda {
namespace {

/// P̄, the joint's own stiffness.
Vec2 own_stiffness(const InterfacePoint& point) {
  return point.physical_stiffness / point.stiffness * point.trial_stiffness();
}

/// D (1 − ε) + ε S at every point (residual_stiffness.hpp).
std::vector<Mat2> with_residual(std::vector<Mat2> tangents, const Equilibrium& equilibrium) {
  for (std::size_t p = 0; p < tangents.size(); ++p)
    tangents[p] =
        (1 - residual_share) * tangents[p] + Mat2(residual_stiffness(equilibrium.point(p)).asDiagonal());
  return tangents;
}

/// Whether parts of what has cracked still press on each other: no structure that has come apart. A law need
/// not be broken for that, its last strength may fade for ever.
bool rests_on_contact(const System& system, const LawValues& laws) {
  return system.has_contacts() &&
         std::ranges::any_of(laws.traction, [](const Vec2& traction) { return traction.x() < 0; });
}

/// D̄ = D (1 + (P̄⁻¹ − P⁻¹) D)⁻¹: the joint's own stiffness p̄ in place of the k that carries its multiplier.
Mat2 with_own_stiffness(const Mat2& d, const InterfacePoint& point) {
  const Vec2 more = own_stiffness(point).cwiseInverse() - point.trial_stiffness().cwiseInverse();
  const Mat2 compliance = more.asDiagonal();
  return d * (Mat2::Identity() + compliance * d).inverse();
}

}  // namespace

/// Bodies that slide as a whole keep a residual stiffness, so that the path has a tangent there.
std::vector<Mat2> System::path_tangents(const LawValues& laws) const {
  std::vector<Mat2> out = joins_by_contact_ ? with_residual(laws.tangent, equilibrium_) : laws.tangent;
  for (std::size_t p = 0; p < out.size(); ++p)
    if (const InterfacePoint& point = equilibrium_.point(p); point.multiplier == Multiplier::iterated)
      out[p] = with_own_stiffness(out[p], point);
  return out;
}

std::vector<Mat2> System::all_tangents(const LawValues& laws, bool is_physical) const {
  std::vector<Mat2> out = laws.tangent;
  for (std::size_t p = 0; p < equilibrium_.num_points(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    if (p >= out.size()) out.emplace_back(point.intact_stiffness().asDiagonal());
    if (is_physical && point.multiplier != Multiplier::none) out[p] = with_own_stiffness(out[p], point);
    out[p] = 0.5 * (out[p] + out[p].transpose()).eval();
  }
  return out;
}

/// K, and where that is singular because parts that have cracked through turn or slide on what they press on,
/// K with a residual stiffness of what is open.
bool System::use_path_tangent(const LawValues& laws) {
  if (!physical_) {
    if (use_tangent(new_stamp(), path_tangents(laws))) return true;
    return !joins_by_contact_ && rests_on_contact(*this, laws) &&
           use_tangent(new_stamp(), with_residual(laws.tangent, equilibrium_));
  }
  path_tangent_ = path_tangents(laws);
  return physical_->set_tangent(path_tangent_);
}

Displacements System::load_direction(const LawValues& laws) {
  if (loading_->reference_offset.empty()) return path_linear().reference_direction();
  std::vector<double> force(equilibrium_.num_unknowns()), out(force.size());
  load_derivative(laws, force);
  path_linear().solve(force, out);
  return Displacements(std::move(out)).scaled(-1);
}

BlockMatrix System::physical_stiffness(const LawValues& laws) const {
  BlockMatrix out = block_stiffness(equilibrium_, all_tangents(laws, true));
  for (std::size_t p = 0; p < laws.tangent.size(); ++p)
    if (laws.is_released(p)) add_stress_energy(out, equilibrium_.point(p));
  return out;
}

bool System::is_path_physical(const LawValues& laws) const {
  if (equilibrium_.num_unknown_multipliers() > 0) return false;
  for (std::size_t p = 0; p < laws.tangent.size(); ++p)
    if (laws.is_released(p) && equilibrium_.point(p).has_stresses()) return false;
  return true;
}

Vec2 System::with_multiplier(std::size_t p, const Vec2& g) const {
  const InterfacePoint& point = equilibrium_.point(p);
  if (!physical_ || point.multiplier != Multiplier::iterated) return g;
  const Vec2 t = path_tangent_[p] * g;
  return g + t.cwiseQuotient(point.trial_stiffness()) - t.cwiseQuotient(own_stiffness(point));
}

/// What is more than D q where q = g + C t, C = P⁻¹ − P̄⁻¹: (1 − D C)⁻¹ t = (1 + D̄ C) t, C of which opens the
/// point itself.
std::vector<Vec2> System::opened_by(std::size_t p, const Vec2& t) {
  const InterfacePoint& point = equilibrium_.point(p);
  const bool is_iterated = physical_ && point.multiplier == Multiplier::iterated;
  const auto opened = [&](const Vec2& by) {
    return Vec2(by.cwiseQuotient(point.trial_stiffness()) - by.cwiseQuotient(own_stiffness(point)));
  };
  const Vec2 carried = is_iterated ? Vec2(t + path_tangent_[p] * opened(t)) : t;
  std::vector<double> tractions(2 * equilibrium_.num_active(), 0.0), d(equilibrium_.num_unknowns(), 0.0);
  Eigen::Map<Vec2>(tractions.data() + 2 * p) = -carried;
  equilibrium_.scatter_add(tractions, d);
  path_linear().solve(std::vector<double>(d), d);
  std::vector<Vec2> out(equilibrium_.num_active());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = with_multiplier(i, equilibrium_.opening(i, d));
  if (is_iterated) out[p] += opened(carried);
  return out;
}

std::optional<Eigen::MatrixXd> System::flexibility(std::span<const LinearSystem::Hinge> hinges) {
  if (physical_) return {};
  return path_linear().flexibility(hinges);
}

std::vector<Vec2> System::multiplier_rates(const Displacements& d) const {
  std::vector<Vec2> out(multipliers_.size());
  for (std::size_t p = 0; p < out.size(); ++p) out[p] = opening_rate(p, d) - jump(p, d);
  return out;
}

std::vector<Vec2> System::left_open(std::span<const double> d, std::span<const Vec2> carried) const {
  std::vector<Vec2> out(multipliers_.size(), Vec2::Zero());
  for (std::size_t p = 0; p < out.size(); ++p)
    if (const InterfacePoint& point = equilibrium_.point(p);
        point.multiplier == Multiplier::iterated && point.perturbation == 0)
      out[p] =
          (path_tangent_[p] * (equilibrium_.opening(p, d) + carried[p])).cwiseQuotient(own_stiffness(point));
  return out;
}

void System::subtract_carried(std::span<const Vec2> carried, std::span<double> force) const {
  std::vector<Vec2> t(carried.size());
  for (std::size_t p = 0; p < t.size(); ++p) t[p] = -(path_tangent_[p] * carried[p]);
  equilibrium_.scatter_add(components(t), force);
}

}  // namespace dda
