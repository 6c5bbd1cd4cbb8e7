#pragma once

#include "framework/figure/drawing.hpp"
#include "studies/dda/case/simulation.hpp"

namespace dda {

/// The picture of a model and the model that it is of.
struct ModelDrawing {
  svg::Drawing& drawing;
  const Simulation& simulation;
};

/// Adds what every gauge measures: a displacement or a reaction at its points, along the line where it is a mean over several
/// blocks; a rotation; a strain or stress along the axis of its largest part, of regions once at their middle. The
/// legend names what has no place, such as the load.
void add_gauges(const ModelDrawing& to);

/// Adds what the section `motion` holds, moves, throws and pulls, where the deck comes to it: held blocks hatched, gravity as
/// an arrow g. The polygons of the drawing are the blocks.
void add_motion(const ModelDrawing& to);

/// Centroid of some blocks together; zero without any.
class Middle {
 public:
  void include(const Block& block) {
    sum_ += block.moments.area * block.moments.centroid;
    area_ += block.moments.area;
  }
  bool is_empty() const { return area_ == 0; }
  Vec2 place() const { return is_empty() ? sum_ : Vec2(sum_ / area_); }

 private:
  Vec2 sum_ = Vec2::Zero();
  double area_ = 0;
};

}  // namespace dda
