#pragma once

#include <pybind11/numpy.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "studies/dda/record/fields.hpp"
#include "studies/dda/run/stepped_run.hpp"

namespace dda::python {

/// A run in memory with what turns its states into fields.
class Followed {
 public:
  /// Reads the deck, meshes and factorises. Throws InputError.
  explicit Followed(DeckFile deck);
  Followed(const Followed&) = delete;
  Followed& operator=(const Followed&) = delete;

  SteppedRun& run() { return run_; }
  const SteppedRun& run() const { return run_; }
  const Fields& fields() const { return fields_; }
  const Equilibrium& equilibrium() const { return run_.simulation().equilibrium(); }

 private:
  SteppedRun run_;
  Fields fields_;
};

/// Outlines of the blocks one after another, those of cut blocks part by part.
struct Outlines {
  std::vector<double> vertices;       ///< x, y of each corner, undeformed [L]
  std::vector<double> displacements;  ///< of each corner [L]
  std::vector<std::int64_t> offsets;  ///< where each outline begins among the corners, and the end
  std::vector<std::int64_t> region;   ///< number of the region of each
};

/// An accepted equilibrium: it stays what it is when the path goes on.
class AcceptedPoint {
 public:
  AcceptedPoint(std::shared_ptr<const Followed> followed, Point point);

  const Point& point() const { return point_; }
  const Candidate& state() const { return at_; }
  /// Number in the deck, from 1, of the stage whose loads the load factor multiplies.
  std::size_t stage() const { return stage_; }
  double load() const { return load_; }
  const std::vector<std::pair<std::string, double>>& gauges() const { return gauges_; }
  const std::vector<std::pair<std::string, double>>& reactions() const { return reactions_; }
  const std::vector<double>& displacements() const { return at_.state.d.all(); }
  std::size_t num_blocks() const { return num_blocks_; }
  /// Openings, tractions and damage of the points that can crack, computed when they are first asked for.
  const Fields::Interface& interface() const;
  /// Blocks as they are there.
  const Outlines& outlines() const;
  /// Computes what will be another structure's when a crack has grown.
  void settle() const {
    if (!followed_->run().simulation().cracks()) return;
    interface();
    outlines();
  }

 private:
  std::shared_ptr<const Followed> followed_;
  Point point_;
  Candidate at_;
  std::size_t stage_, num_blocks_;
  double load_;
  std::vector<std::pair<std::string, double>> gauges_, reactions_;
  mutable std::unique_ptr<const Fields::Interface> interface_;
  mutable std::unique_ptr<const Outlines> outlines_;
};

}  // namespace dda::python
