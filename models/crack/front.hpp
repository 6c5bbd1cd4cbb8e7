#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "models/body/body.hpp"
#include "models/crack/initiation.hpp"
#include "models/parameters.hpp"

namespace dda {

/// Cracks that run through blocks: where they end, and the straight segment ahead of each.
///
/// The segment ahead is provisional: its points stand in the structure like those of any cut, intact. Where the first
/// of them reaches its strength the segment is aimed once more, by the direction rule, and cut anew if that changes
/// it by more than a degree; else the crack has grown by it, and the next segment is cut straight on. A segment runs
/// through block after block until it is long enough; a side that leaves its end within six degrees of the way is
/// opened instead of a cut, and so is the closest one where the way leads back into the block just cut. Where a part
/// of a block would be too small the cut begins at a corner next to it, or else the way is turned by two degrees, up to
/// twelve times. A crack that finds no way is stuck, and so is one that turns back towards its beginning.
///
/// Where `begin` is `automatic`, the first crack of an entry stands from the start where tension first reaches the
/// strength there by the elastic solution. Once something has cracked, further ones begin, and one that has not grown yet
/// moves, where tension is 0.9 of the strength there; its own points decide when it grows.
///
/// A crack ends at the boundary, at an interface where it is told to, and at a region through which no cracks run. Any
/// other interface it may cross: the segment ahead then lies beyond it and has the law of the region there, and what
/// comes first decides. With the traction t of the intact structure, tension t_n = n·σn normal to the straight way,
///
///     it crosses        where first  ⟨t_n⟩² + (t_s/β)² = ft²   of the region beyond, at a point of the segment
///     runs along        where first the same holds of the interface's law, at a point of the interface
///     stops             where neither does,
///
/// and from there on the fracture energies of both laws decide how far each opens. At another crack it ends: the part
/// of the block up to there is cut off, and moves beside that crack by the jumps of both. A segment on which another
/// crack ends is aimed no more, nor is one on which energy has been spent, which would be lost with it.
class CrackFront {
 public:
  /// Throws InputError for cracks that do not begin on the outline of a block.
  CrackFront(CrackGeometry& geometry, const Body& body, const ModelParameters& model);

  /// What is known of the structure as it stands.
  struct Surroundings {
    /// Stress (σx, σy, τxy) at a point; nothing outside of the body.
    std::function<std::optional<Vec3>(const Vec2&)> stress;
    /// Energy that is released once some cuts, of the geometry as it is now, bear no traction [FL].
    std::function<double(std::span<const Cut> free)> released;
  };

  const CrackGeometry& geometry() const { return geometry_; }
  std::size_t num_cracks() const { return cracks_.size(); }
  /// Cuts the first segment of every crack whose place is given.
  void begin();
  bool is_automatic() const;
  /// The same of the first crack of entries that begin by themselves, which stands ready: σ + λ dσ/dλ of the whole structure
  /// by stages, of which the first that asks for a crack decides.
  void begin_where_asked(const std::vector<BlockStress>& elastic);
  /// A crack that stress asks for.
  struct Asked {
    std::size_t entry;
    CrackStart start;
    std::optional<int> moved;  ///< one that has not grown, and moves there
  };
  /// By the stresses σ now. Nothing where no entry asks for a crack. Cracks on whose segment ahead energy has been spent
  /// do not move.
  std::optional<Asked> asked(const std::vector<Vec3>& stress, const std::set<int>& spent_on = {});
  /// Where, before anything has cracked, one that stands ready is asked for sooner than where it stands, as the load grows:
  /// σ now and its rates.
  std::optional<Asked> asked_sooner(const BlockStress& growing);
  /// The place where tension asks most for one, whether there may be more or not, that no crack runs next to.
  std::optional<Asked> left_out(const std::vector<Vec3>& stress) const;
  /// Corners at which cracks may begin by themselves, and of which too few blocks tell whether they do.
  std::vector<ShallowCorner> shallow_corners() const;
  /// Cuts its first segment; its number, or nothing where that cannot be cut.
  std::optional<int> start(const Asked& crack);
  /// Aims the segment ahead of a crack; whether it is another one now.
  bool aim(int crack, const Surroundings& around);
  /// The crack has grown by the segment ahead; whether there is a next one.
  bool grow(int crack);
  /// Why it goes no farther; "" while it does.
  const std::string& end_of(int crack) const { return at(crack).end.reason; }
  /// Whether that is for want of a way: nothing of the structure holds it up.
  bool is_stuck(int crack) const { return at(crack).end.is_stuck; }
  /// End of what has grown.
  const Vec2& tip(int crack) const { return at(crack).tip; }

  /// Where a crack goes no farther.
  struct End {
    std::string reason = {};  ///< none while it goes on
    bool is_stuck = false;
  };
  /// What is remembered of a crack beside its cuts.
  struct Memory {
    std::size_t entry = 0;  ///< of the deck's `cracks`
    Vec2 tip, direction;    ///< of what has grown
    int aims = 0;           ///< of the segment ahead
    End end = {};
  };
  const std::vector<Memory>& memory() const { return cracks_; }
  /// Whether cracks may be those of this structure: as many of each entry as begin at given places, and any number
  /// of an entry whose cracks begin by themselves.
  bool may_have(const std::vector<Memory>& cracks) const;
  /// Replays cuts as they were.
  void restore(const std::vector<Cut>& cuts, std::vector<Memory> memory);

 private:
  Memory& at(int crack) { return cracks_[static_cast<std::size_t>(crack)]; }
  const Memory& at(int crack) const { return cracks_[static_cast<std::size_t>(crack)]; }
  const CrackParameters& parameters(int crack) const { return model_.cracks[at(crack).entry]; }
  /// Cuts the segment ahead, at least so long; whether any cut was made.
  bool cut_ahead(int crack, const Vec2& direction, double length);
  bool cut_ahead(int crack, const Vec2& direction);
  /// Energy that a straight way would release, between what its cuts up to either side of that length do.
  std::optional<double> released(int crack, const Vec2& way, double length, const Surroundings& around);
  /// Cuts on from a point; where that leads, or nothing.
  std::optional<Vec2> cut_once(int crack, const Vec2& from, const Vec2& direction);
  std::optional<Vec2> cut_through(int crack, BlockId block, const Vec2& from, const Vec2& direction);
  /// The same from a corner next to that point; where a side leads there it is opened.
  std::optional<Vec2> cut_from_corner(int crack, const Vec2& from, const Vec2& direction);
  std::optional<Vec2> open_side(int crack, const Vec2& from, const Vec2& direction, double within);
  std::string end_at(int crack, const Vec2& x, const Vec2& direction) const;
  /// Whether that is the place where a crack begins.
  bool begins_at(int crack, const Vec2& x) const { return !has_grown(crack) && x == at(crack).tip; }
  /// Cracks of an entry, without those that have come to an end close to where they have begun.
  std::int64_t num_begun(std::size_t entry) const;
  /// Whether a crack stands, but for the size of blocks, at a place.
  bool is_near(int crack, const Vec2& x) const;
  /// The crack of an entry that has not grown, without which its places are looked for.
  std::optional<int> ready(std::size_t entry, const std::set<int>& spent_on) const;
  /// The first of some places at which a crack can be cut.
  std::optional<Asked> first_to_cut(std::size_t entry, std::span<const CrackStart> places,
                                    std::optional<int> moved);
  std::string why_not_from(const Vec2& x, const std::string& end) const;
  bool passes(int crack, std::size_t side) const;
  bool is_open_to_cracks(int region) const { return resistance_.contains(region); }
  /// A corner of the block next to a point of its outline, else the point: passing so close by a corner a crack would
  /// cut off next to nothing of the block behind it.
  Vec2 corner_near(BlockId block, const Vec2& x) const;
  /// Whether another crack ends on one of its cuts.
  bool is_met(const std::vector<Cut>& ahead) const;
  CrackStarts::Wish wish_of(std::size_t entry) const;
  bool has_grown(int crack) const;
  std::optional<Asked> asked_of(std::size_t entry, const BlockStress& stress, const std::set<int>& spent_on);
  std::vector<Cut> ahead_of(int crack) const;
  void drop_ahead(int crack);
  void replay(const Cut& cut);

  CrackGeometry& geometry_;
  const Body& body_;
  const ModelParameters& model_;
  std::vector<Memory> cracks_;
  /// Of the law that cracks have in a region.
  struct Resistance {
    double strength = 0;                    ///< ft [F/L²]
    double characteristic_length = 0;       ///< of the cohesive zone [L]
    std::optional<RandomField> field = {};  ///< by which ft varies
  };
  std::map<int, Resistance> resistance_;                     ///< by region
  std::vector<BoundaryPoint> held_;                          ///< along the boundary
  std::map<std::size_t, std::string> ends_;                  ///< interfaces under some `end_at`, by side
  std::vector<std::shared_ptr<const CrackDirection>> rule_;  ///< of each entry
};

}  // namespace dda
