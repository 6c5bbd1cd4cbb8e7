#pragma once

#include <string>

#include "studies/dda/sweep/description/sweep.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda::test {

/// A deck of Voronoi blocks; `more` is appended, with its newline.
inline std::string small_deck(const std::string& more = "") {
  return R"(title: A small beam
scene:
  regions: [{material: stone, vertices: [[0, 0], [3, 0], [3, 1], [0, 1]]}]
  subdivision: {type: voronoi, blocks: 8}
thickness: 1
materials: {stone: {type: linear_elastic, young_modulus: 100, poisson_ratio: 0.2}}
supports: {left: {at: [0, 0], fix: xy}, right: {at: [3, 0], fix: y}}
stages: [{loads: [{type: point_load, at: [1.5, 1], force: [0, -1]}]}]
)" + more;
}

/// A folder with the sweep `s.yaml` beside the decks `a.yaml` and `b.yaml`.
class SweepExample {
 public:
  explicit SweepExample(const std::string& text) {
    put(scratch_ / "a.yaml", small_deck());
    put(scratch_ / "b.yaml", small_deck("units: {length: m, force: kN}\n"));
    put(scratch_ / "s.yaml", text);
  }
  Sweep read(const std::vector<std::string>& overrides = {}) const {
    return read_sweep(scratch_ / "s.yaml", overrides);
  }
  const Scratch& folder() const { return scratch_; }

 private:
  Scratch scratch_;
};

}  // namespace dda::test
