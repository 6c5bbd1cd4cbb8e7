#pragma once

#include "continuation/stability/eigenmodes.hpp"

namespace dda {

/// The modes of the intact structure, and what is known of each along a path.
struct TrackedModes {
  std::vector<double> first_values;         ///< μ₀, of the intact structure
  std::vector<std::vector<double>> shapes;  ///< where each was seen last

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("first_values", self.first_values);
    visit("shapes", self.shapes);
  }
};

/// Follows modes through crossings by the modal assurance criterion: of all pairs of a tracked and a present
/// shape the most alike belong together, then the next, as long as more than half of a shape is in the other.
class ModeTracker {
 public:
  ModeTracker() = default;
  explicit ModeTracker(TrackedModes known) : known_(std::move(known)) {}

  /// Begins with these.
  void start(const Eigenmodes& intact) { known_ = {intact.values, intact.shapes}; }
  bool has_started() const { return !known_.first_values.empty(); }
  /// Position, among the present modes, of each tracked one; −1 where it is not among them.
  std::vector<int> follow(const Eigenmodes& present, const Mass& mass);
  const TrackedModes& known() const { return known_; }

 private:
  TrackedModes known_;
};

}  // namespace dda
