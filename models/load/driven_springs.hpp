#pragma once

#include <span>
#include <vector>

#include "models/load/load.hpp"

namespace dda {

/// 1 where two functionals measure the same displacement, −1 where the opposite, 0 else.
double sense_of(const Functional& one, const Functional& other);

/// What loads drive: one spring for a place and a direction, whatever stages move its far end, so that what one stage has
/// driven there another drives on or back.
class DrivenSprings {
 public:
  /// Gives what a load of a stage drives its springs, and names where it has none: that of what has been driven there before;
  /// else `driven`, with a number where another direction has that name. Throws InputError where the stage drives it already,
  /// and where it had another name before.
  void place(std::size_t stage, std::span<DrivenSpring> of_load);
  /// The first that has moved each.
  const std::vector<DrivenSpring>& springs() const { return springs_; }

 private:
  struct Known {
    std::size_t spring = 0;
    double sense = 0;  ///< 1 or −1; 0 where nothing is driven there
  };
  Known find(const DrivenSpring& driven) const;
  void go_on(std::size_t stage, const Known& known, DrivenSpring& driven);
  std::string name_along(const Vec2& direction);

  std::vector<DrivenSpring> springs_;
  std::vector<std::size_t> stages_;  ///< that have driven each last
  std::vector<Vec2> directions_;     ///< of what is called driven, driven_2, ...
};

}  // namespace dda
