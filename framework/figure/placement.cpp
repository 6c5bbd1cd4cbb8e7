#include "framework/figure/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda::svg {
namespace {

double shared_area(const Box& a, const Box& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0.0;
}

/// Length of the segment from p to q inside the box. Source: Liang and Barsky, ACM TOG 3 (1984).
double length_inside(const Box& box, std::pair<double, double> p, std::pair<double, double> q) {
  const double dx = q.first - p.first, dy = q.second - p.second;
  double enter = 0, leave = 1;
  for (const auto& [slope, room] :
       {std::pair{-dx, p.first - box.x}, std::pair{dx, box.right() - p.first},
        std::pair{-dy, p.second - box.y}, std::pair{dy, box.bottom() - p.second}}) {
    if (slope == 0 && room < 0) return 0;
    if (slope < 0) enter = std::max(enter, room / slope);
    if (slope > 0) leave = std::min(leave, room / slope);
  }
  return leave > enter ? (leave - enter) * std::hypot(dx, dy) : 0.0;
}

}  // namespace

double LabelPlacer::cost(const Box& box) const {
  constexpr double leaving_frame = 1000, on_label = 100, on_curve = 10;
  double sum = leaving_frame * (box.width * box.height - shared_area(box, frame_));
  for (const Box& other : taken_) sum += on_label * shared_area(box, other);
  for (const Track& track : tracks_) {
    for (std::size_t i = 1; i < track.size(); ++i)
      sum += on_curve * length_inside(box, track[i - 1], track[i]);
  }
  return sum;
}

Box LabelPlacer::place(double x, double y, double width, double height) {
  Box best;
  double least = std::numeric_limits<double>::infinity();
  // Near places first: a later one must be truly better.
  for (const double gap : {7.0, 16.0, 28.0, 44.0}) {
    for (const auto& [right, down] :
         {std::pair{1, -1}, {1, 0}, {1, 1}, {0, -1}, {0, 1}, {-1, -1}, {-1, 0}, {-1, 1}}) {
      const double side = right == 0 || down == 0 ? gap : 0.7 * gap;
      const Box box{x + right * side + (right - 1) * width / 2, y + down * side + (down - 1) * height / 2,
                    width, height};
      const double now = cost(box) + gap;
      if (now < least) {
        least = now;
        best = box;
      }
    }
  }
  taken_.push_back(best);
  return best;
}

}  // namespace dda::svg
