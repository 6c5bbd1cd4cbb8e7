#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "framework/figure/canvas.hpp"

namespace dda::svg {

/// A polyline on the picture [px].
using Track = std::vector<std::pair<double, double>>;

/// Finds room for the labels of marked points: inside a frame, off the curves and off each other.
class LabelPlacer {
 public:
  LabelPlacer(const Box& frame, std::vector<Track> tracks) : frame_(frame), tracks_(std::move(tracks)) {}

  /// The box of a text of that size beside (x, y); the best of a few places around the point.
  Box place(double x, double y, double width, double height);
  /// Keeps a place free of labels.
  void keep_free(const Box& box) { taken_.push_back(box); }

 private:
  double cost(const Box& box) const;

  Box frame_;
  std::vector<Track> tracks_;
  std::vector<Box> taken_;
};

}  // namespace dda::svg
