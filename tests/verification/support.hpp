#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "continuation/path/path.hpp"
#include "models/equilibrium/equilibrium.hpp"
#include "studies/dda/case/deck/deck.hpp"

namespace dda::verification {

/// A deck made into blocks and their equilibrium, without a path.
struct Structure {
  Deck deck;
  Assembly assembly;
  Body body;
  Equilibrium equilibrium;

  explicit Structure(const std::string& deck_text);
};

/// An accepted point of a path with everything that closed forms speak of.
struct Traced {
  std::string control;
  State state;
  double load = 0;                                 ///< load gauge
  double dissipated = 0, stored = 0, work = 0;     ///< [F L]
  std::map<std::string, double> gauges;            ///< by deck name
  int negative = -1, negative_under_control = -1;  ///< eigenvalues, −1 when unknown
  bool switched = false;
};

/// A path followed to its end.
struct Trace {
  std::vector<Traced> points;
  Ending ending;

  const Traced& last() const { return points.back(); }
  /// Index of the largest load.
  std::size_t peak() const;
};

/// Follows the path of a deck given as text.
Trace follow(const std::string& deck_text);

/// The matrix written out, 6 · blocks square.
Eigen::MatrixXd dense(const BlockMatrix& matrix);

/// K⁻¹ f by the default sparse solver.
std::vector<double> solve(const BlockMatrix& matrix, std::vector<double> force);

/// Full reference load of the last stage on the intact structure: d = K₀⁻¹ (dead + reference).
std::vector<double> intact_response(const Equilibrium& equilibrium);

/// Smallest eigenvalue of the matrix scaled to a unit diagonal: its sign is that of the matrix's own, and
/// blocks of unlike size or stiffness cost no digits.
double smallest_scaled_eigenvalue(const BlockMatrix& matrix);

/// Two blocks 40 × 10 × 2, E = 1000, pressed together by 3 and joined at one point with this treatment and
/// law. `stages` are the lines of further stages; the gauges `slip` of the joint and `pushed` of the upper
/// block.
std::string pressed_blocks(const std::string& treatment, const std::string& law, const std::string& stages,
                           const std::string& path = "{}");

/// Strain (εx, εy, γxy) of a block.
Vec3 strain_of(const std::vector<double>& d, std::size_t block);

}  // namespace dda::verification
