#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "studies/dda/record/fields.hpp"

namespace dda {

struct Measurement;
class CrackFront;

/// A segment by which a crack through blocks has grown, and where on the path.
struct GrownSegment {
  int crack = 0;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  int step = 0;
  double load = 0;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("crack", self.crack);
    visit("from", self.from);
    visit("to", self.to);
    visit("step", self.step);
    visit("load", self.load);
  }
};

/// Notes by how much cracks have grown since the segments that are known.
void note_growth(const CrackFront& front, const Measurement& now, std::vector<GrownSegment>& grown);

/// Each crack at the end of a run, as it stands in `summary.json`:
///
///     path         corners, from where it began to its tip [L];  length [L]
///     mean_turn    mean |angle| between one segment and the next [°]; absent with fewer than two
///     ended        why it goes no farther; absent while it does
///     cuts         block (side: it runs along one), ends, step and load at which it grew;
///                  at the end its largest opening w_n and sliding |w_s|, and its mean damage
nlohmann::ordered_json cracks_summary(const CrackFront& front, const std::vector<GrownSegment>& grown,
                                      const Fields& fields, const StoredState& end);

}  // namespace dda
