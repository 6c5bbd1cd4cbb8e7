#pragma once

#include <span>
#include <string>
#include <vector>

namespace dda {

/// Which unknowns a step is solved in: the openings of the points that crack, or the displacements of all
/// blocks.
enum class Unknowns { cracked, whole };

/// Where equations are evaluated.
struct Iterate {
  std::span<const double> x;
  double load_factor = 0;
};

/// What an iteration has come to.
struct Verdict {
  enum class Kind { goes_on, converged, failed };
  Kind kind = Kind::goes_on;
  std::string reason = {};  ///< why it fails, or would if nothing further were found
};

/// Equilibrium in some unknowns, closed by a control:
///
///     F(x, λ) = 0,     N(x, λ) = 0
///
/// NOX and LOCA see these equations through one adapter (modules/loca). They are asked at one iterate after
/// another and remember what they have computed at the last. A singular Jacobian is said by `factorise`.
class Equations {
 public:
  virtual ~Equations() = default;
  virtual Unknowns unknowns() const = 0;
  /// n of x.
  virtual std::size_t size() const = 0;
  /// F.
  virtual void residual(const Iterate& at, std::span<double> out) = 0;
  /// ‖F‖ in one unit, what a line search brings down.
  virtual double norm(const Iterate& at) = 0;
  /// ∂F/∂λ.
  virtual void load_derivative(const Iterate& at, std::span<double> out) = 0;
  /// Prepares J = ∂F/∂x; false when it is singular.
  virtual bool factorise(const Iterate& at) = 0;
  /// columns ← J⁻¹ columns, after `factorise` at the same place.
  virtual void solve(const Iterate& at, std::span<const std::span<double>> columns) = 0;
  /// out = J in, likewise.
  virtual void multiply(const Iterate& at, std::span<const double> in, std::span<double> out) = 0;
  /// N.
  virtual double control(const Iterate& at) = 0;
  /// Adds ∂N/∂x to zeros and returns ∂N/∂λ.
  virtual double control_gradient(const Iterate& at, std::span<double> per_x) = 0;
  /// ∂N/∂s, s the path parameter of the control.
  virtual double per_path() const = 0;
  /// Whether an iterate is the solution; called once with each, `iterations` having led to it.
  virtual Verdict judge(const Iterate& at, int iterations) = 0;
};

/// Equations that are piecewise linear where they are not smooth, and can be solved in a finite number of
/// pieces: the solution of the equations made linear at an iterate, but for contact and friction.
class WalkedEquations : public Equations {
 public:
  /// x and, behind it, λ; empty where no walk ends.
  virtual std::vector<double> walk_from(const Iterate& at) = 0;
};

}  // namespace dda
