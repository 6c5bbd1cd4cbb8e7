#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace dda {

/// Rates of a structure some of whose points stand at a corner of their laws, where the damage may grow or
/// rest, and friction slide or hold. Each is a hinge:
///
///     ψ + M ⟨ψ⟩ = λ̇ b,     t_i = D_i q_i + a_i ⟨ψ_i⟩,   ψ_i = g_i · q_i   (all of them rates)
///
/// with M_ij what the traction a_j of hinge j takes from ψ_i, and b what the load alone gives with all hinges
/// at rest. Solutions are rays: with (λ̇, ψ) also each positive multiple of it.
struct HingedRates {
  Eigen::MatrixXd couplings;  ///< M, n × n
  Eigen::VectorXd per_load;   ///< b, size n
};

/// One of those rays.
struct RateRay {
  std::vector<bool> goes_on;  ///< ψ > 0
  double load_factor = 0;     ///< λ̇, its sign
};

/// Where the structure gets whose hinges are all a little short of their corners when its load is raised
/// (`direction` 1) or lowered (−1):
///
///     ψ + M ⟨ψ⟩ = λ b − p,     p > 0,     from λ = 0, ψ = −p
///
/// Its solutions are a line of straight pieces without branches, along which one hinge after another starts
/// and stops while the load rises and falls; far away both of its ends are rays of the problem without p
/// (Lemke's pivoting). So the two directions find two different rays: where a path has come to an end of its
/// straight piece, one that goes on and one that goes back. The line may also be closed, which tells
/// nothing: then other p are tried. Nothing when all of them circle, as they do where there is no ray at all;
/// that there is none is not proven by it.
std::optional<RateRay> follow_hinges(const HingedRates& rates, double direction);

}  // namespace dda
