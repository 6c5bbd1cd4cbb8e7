#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "models/crack/front.hpp"
#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// How the unknowns and points of a structure follow from those it had before its cuts changed: blocks, sides and the
/// cuts that are still there are the same ones, new jumps are closed and new points intact.
struct Growth {
  /// The number each had before; nothing of new ones.
  std::vector<std::optional<std::size_t>> nodes, points;
  std::size_t same_cuts = 0;     ///< the first cuts, which are what they were, in the same order
  bool keeps_stiffness = false;  ///< the intact stiffness of the blocks is what it was, but for rounding

  /// Of an equilibrium that has been made anew with the cuts that it had, but another stiffness.
  static Growth unchanged(const Equilibrium& equilibrium);
  /// Unknowns, six per node; zero of new nodes, and of those behind the last that is given.
  std::vector<double> unknowns(const std::vector<double>& before) const;
  /// What is known of each active point; zero of new ones.
  template <class T>
  std::vector<T> of_points(const std::vector<T>& before) const {
    std::vector<T> out;
    for (const auto& point : points) out.push_back(point ? before[*point] : zero<T>());
    return out;
  }

 private:
  template <class T>
  static T zero() {
    if constexpr (requires { T::Zero(); })
      return T::Zero();
    else
      return {};
  }
};

/// A structure that cracks run through: what changes its cuts, and what is made of them.
class CrackedStructure {
 public:
  CrackedStructure(CrackFront& front, const Body& body, const ModelParameters& model,
                   Equilibrium& equilibrium)
      : front_(front), body_(body), model_(model), equilibrium_(equilibrium) {}

  CrackFront& front() { return front_; }
  const CrackFront& front() const { return front_; }
  const Body& body() const { return body_; }
  /// Makes the equilibrium anew for the cuts that there are now; `before` are those that it was made for.
  Growth remake(const std::vector<Cut>& before);
  /// Another equilibrium for the cuts that there are now, and how its unknowns follow from those of this one.
  std::pair<Equilibrium, Growth> tried(const std::vector<Cut>& before) const;
  /// Mean σ of each block: (σx, σy, τxy) [F/L²].
  std::vector<Vec3> stress(const Loading& loading, std::span<const double> d, double load_factor) const;
  /// The same and its rates, of displacements and a load factor that grow.
  struct Place {
    std::span<const double> d;
    double load_factor;
  };
  BlockStress growing(const Loading& loading, const Place& at, const Place& rate) const;

 private:
  CrackFront& front_;
  const Body& body_;
  const ModelParameters& model_;
  Equilibrium& equilibrium_;
};

}  // namespace dda
