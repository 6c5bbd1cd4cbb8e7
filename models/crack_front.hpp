#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "models/body/body.hpp"
#include "models/parameters.hpp"

namespace dda {

/// Cracks that run through blocks: where they end, and the straight segment ahead of each.
///
/// The segment ahead is provisional: its points stand in the structure like those of any cut, intact. Where the first
/// of them reaches its strength the segment is aimed once more, by the direction rule, and cut anew if that changes
/// it by more than a degree; else the crack has grown by it, and the next segment is cut straight on. A segment runs
/// through block after block until it is long enough; a side that leaves its end within six degrees of the way is
/// opened instead of a cut, and so is the closest one where the way leads back into the block just cut. Where no part
/// of a block would be large enough the way is turned by two degrees, up to twelve times.
///
/// A crack ends at the boundary, at an interface where it is told to, at another region, and at another crack.
class CrackFront {
 public:
  /// Throws InputError for cracks that do not begin on the outline of a block.
  CrackFront(CrackGeometry& geometry, const Body& body, const ModelParameters& model);

  /// Stress (σx, σy, τxy) at a point; nothing outside of the body.
  using Stress = std::function<std::optional<Vec3>(const Vec2&)>;

  const CrackGeometry& geometry() const { return geometry_; }
  std::size_t num_cracks() const { return cracks_.size(); }
  /// Cuts the first segment of every crack.
  void begin();
  /// Aims the segment ahead of a crack; whether it is another one now.
  bool aim(int crack, const Stress& stress);
  /// The crack has grown by the segment ahead; whether there is a next one.
  bool grow(int crack);
  /// Why it goes no farther; "" while it does.
  const std::string& end_of(int crack) const { return at(crack).end; }
  /// End of what has grown.
  const Vec2& tip(int crack) const { return at(crack).tip; }

  /// What is remembered of a crack beside its cuts.
  struct Memory {
    Vec2 tip, direction;  ///< of what has grown
    int aims = 0;         ///< of the segment ahead
    std::string end;
  };
  const std::vector<Memory>& memory() const { return cracks_; }
  /// Replays cuts as they were.
  void restore(const std::vector<Cut>& cuts, std::vector<Memory> memory);

 private:
  Memory& at(int crack) { return cracks_[static_cast<std::size_t>(crack)]; }
  const Memory& at(int crack) const { return cracks_[static_cast<std::size_t>(crack)]; }
  const CrackParameters& parameters(int crack) const { return model_.cracks[model_.entry_of_crack(crack)]; }
  /// Cuts the segment ahead; whether any cut was made.
  bool cut_ahead(int crack, const Vec2& direction);
  /// Cuts on from a point; where that leads, or nothing.
  std::optional<Vec2> cut_once(int crack, const Vec2& from, const Vec2& direction);
  std::optional<Vec2> open_side(int crack, const Vec2& from, const Vec2& direction, double within);
  std::string end_at(int crack, const Vec2& x, const Vec2& direction) const;
  bool passes(int crack, std::size_t side) const;
  bool is_inside(int crack, BlockId block) const;
  std::vector<Cut> ahead_of(int crack) const;
  void drop_ahead(int crack);
  void replay(const Cut& cut);

  CrackGeometry& geometry_;
  const Body& body_;
  const ModelParameters& model_;
  std::vector<Memory> cracks_;
  std::vector<double> strength_;                             ///< of the law of each crack [F/L²]
  std::vector<std::shared_ptr<const CrackDirection>> rule_;  ///< of each entry
};

}  // namespace dda
