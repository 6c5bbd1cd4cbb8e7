#pragma once

#include <memory>
#include <optional>

#include "meshing/cracks/parted.hpp"
#include "models/equilibrium/equilibrium.hpp"
#include "models/parameters.hpp"

namespace dda {

/// A structure as it is let go: where cracks have run through blocks their parts are blocks of their own, and blocks of
/// second order are of first. Loads, supports and gauges act on the parts that they are on.
class Pieces {
 public:
  /// References have to live as long.
  Pieces(const Body& whole, const Equilibrium& equilibrium, const ModelParameters& model);

  const Body& whole() const { return whole_; }
  const Body& body() const { return body_ ? *body_ : whole_; }
  const Equilibrium& equilibrium() const { return equilibrium_ ? *equilibrium_ : of_whole_; }
  /// Displacements d of a piece in first order, about its own centroid, from those of all nodes of the whole.
  Vec6 displacements(std::size_t piece, std::span<const double> d) const;
  /// Pieces on either side of a point of the whole: of its first and of its second block.
  std::pair<std::size_t, std::size_t> beside(const InterfacePoint& point) const;
  /// Whether a block of the whole has been cut.
  bool is_cut(BlockId whole) const { return parted_ && parted_->of_whole[whole.value()].size() > 1; }
  /// Whether cracks have run through blocks.
  bool are_cut() const { return parted_.has_value(); }
  /// Whether blocks of second order are of first from here on, none of which is cut: joints that cannot crack are then those
  /// of first order.
  bool are_lowered() const { return !parted_ && body_; }

 private:
  const Body& whole_;
  const Equilibrium& of_whole_;
  std::optional<Parted> parted_;      ///< none where no block is cut
  std::unique_ptr<const Body> body_;  ///< null where it is the whole
  std::unique_ptr<const Equilibrium> equilibrium_;
};

}  // namespace dda
