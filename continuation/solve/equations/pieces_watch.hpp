#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dda {

/// Watches the sets of pieces of their laws that an iteration's points are on (fingerprints), for when it goes
/// round between them.
///
/// Newton's method that comes back to a set which it has left would go the same way for ever, but for a line
/// search and for what is not linear on a piece. Iterations on sets that it has seen are counted; those that
/// bring a new one make progress.
class PiecesWatch {
 public:
  /// Called with each iterate, the first included.
  void see(std::size_t pieces) {
    const bool is_old = std::ranges::find(seen_, pieces) != seen_.end();
    stays_ = !seen_.empty() && pieces == last_;
    returns_ = is_old && !stays_;
    on_seen_ += is_old;
    if (!is_old) seen_.push_back(pieces);
    last_ = pieces;
  }
  /// Whether the last set is that before it.
  bool stays() const { return stays_; }
  /// Whether the last set is one that had been left.
  bool returns() const { return returns_; }
  /// Iterations that brought no new set.
  int on_seen_sets() const { return on_seen_; }

 private:
  std::vector<std::size_t> seen_;
  std::size_t last_ = 0;
  bool stays_ = false, returns_ = false;
  int on_seen_ = 0;
};

}  // namespace dda
