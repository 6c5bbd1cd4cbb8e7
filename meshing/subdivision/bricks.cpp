#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "meshing/geometry/voronoi.hpp"
#include "meshing/room.hpp"
#include "meshing/subdivision/parts.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

enum class Bond { stack, running, flemish, english };

/// A course: bricks of these lengths one after the other, again and again, one of which begins at `start`.
struct Course {
  std::vector<double> lengths;
  double start = 0, height = 0;

  double period() const { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }
};

struct CourseParameters {
  std::vector<double> lengths;
  std::optional<double> height;
  double offset = 0;
  Position where;
};

struct BricksParameters {
  double length = 0, height = 0;
  std::optional<double> header, overlap;
  Bond bond = Bond::running;
  std::vector<CourseParameters> courses;
  std::optional<Vec2> origin;
  Position where;
};

/// Courses that come again and again, from below.
class Courses {
 public:
  explicit Courses(const BricksParameters& p) : courses_(p.courses.empty() ? of_bond(p) : as_said(p)) {
    if (p.courses.empty()) shortest_ = std::min(p.height, header_of(p));
    for (const Course& course : courses_) {
      bottoms_.push_back(period_);
      period_ += course.height;
      shortest_ = std::min({shortest_, course.height, std::ranges::min(course.lengths)});
    }
  }

  /// Calls visit(course, from, to) of every one between two heights above the lowest.
  void between(double low, double high,
               const std::function<void(const Course&, double, double)>& visit) const {
    const auto n = static_cast<std::int64_t>(courses_.size());
    for (std::int64_t j = n * static_cast<std::int64_t>(std::floor(low / period_)); bottom(j) < high; ++j)
      if (bottom(j + 1) > low)
        visit(courses_[static_cast<std::size_t>(((j % n) + n) % n)], bottom(j), bottom(j + 1));
  }
  double shortest() const { return shortest_; }  ///< side of a brick
  double mean_area() const {
    double area = 0;
    for (const Course& course : courses_)
      area += course.height * course.period() / static_cast<double>(course.lengths.size());
    return area / static_cast<double>(courses_.size());
  }

 private:
  /// The same for every region, to the last bit.
  double bottom(std::int64_t j) const {
    const auto n = static_cast<std::int64_t>(courses_.size()), within = ((j % n) + n) % n;
    return static_cast<double>((j - within) / n) * period_ + bottoms_[static_cast<std::size_t>(within)];
  }
  static double header_of(const BricksParameters& p) { return p.header.value_or(p.length / 2); }
  static std::vector<Course> as_said(const BricksParameters& p) {
    std::vector<Course> out;
    for (const CourseParameters& course : p.courses)
      out.push_back({course.lengths.empty() ? std::vector{p.length} : course.lengths, course.offset,
                     course.height.value_or(p.height)});
    return out;
  }
  static std::vector<Course> of_bond(const BricksParameters& p) {
    const double length = p.length, height = p.height, header = header_of(p);
    switch (p.bond) {
      case Bond::stack:
        return {{{length}, 0, height}};
      case Bond::running:
        return {{{length}, 0, height}, {{length}, -p.overlap.value_or(0.5) * length, height}};
      case Bond::flemish:
        return {{{length, header}, 0, height}, {{length, header}, -(length + header) / 2, height}};
      case Bond::english:
        return {{{length}, 0, height}, {{header}, -header / 2, height}};
    }
    return {};
  }

  std::vector<Course> courses_;
  std::vector<double> bottoms_;  ///< of each above that of the first
  double period_ = 0, shortest_ = std::numeric_limits<double>::infinity();
};

/// Courses of bricks whose joints have no thickness, cut at the outline.
class Bricks final : public Subdivision {
 public:
  explicit Bricks(BricksParameters parameters) : p_(std::move(parameters)), courses_(p_) {}

  Cells divide(const Layout& layout) const override {
    if (layout.model) require_sound(layout);
    require_room(area_of(layout) / courses_.mean_area(), p_.where);
    const std::vector<LayoutPart> parts = parts_of(layout);
    return cells_of_parts(layout, parts, [&](std::size_t i) {
      const Vec2 origin = p_.origin.value_or(box_of_region(layout, parts[i].region).low);
      return cells_in(parts[i].figure, pattern(origin, bounding_box(parts[i].figure.outline.vertices)),
                      courses_.shortest());
    });
  }

 private:
  static Box box_of_region(const Layout& layout, int region) {
    Box out;
    for (const Shape& shape : layout.shapes)
      if (shape.region == region)
        for (const Vec2& corner : shape.figure.outline.vertices) out.include(corner);
    return out;
  }

  std::vector<Polygon> pattern(const Vec2& origin, const Box& box) const {
    std::vector<Polygon> bricks;
    courses_.between(box.low.y() - origin.y(), box.high.y() - origin.y(),
                     [&](const Course& course, double bottom, double top) {
                       add_course(course, origin.x(),
                                  {{box.low.x(), origin.y() + bottom}, {box.high.x(), origin.y() + top}},
                                  bricks);
                     });
    return bricks;
  }

  /// Bricks that cover a box from its left to its right.
  static void add_course(const Course& course, double origin, const Box& box, std::vector<Polygon>& bricks) {
    const double begin = origin + course.start, period = course.period();
    double right = begin + std::floor((box.low.x() - begin) / period) * period;
    for (std::size_t i = 0; right < box.high.x(); ++i) {
      const double left = right;
      right += course.lengths[i % course.lengths.size()];
      if (right > box.low.x())
        bricks.push_back(
            {{{left, box.low.y()}, {right, box.low.y()}, {right, box.high.y()}, {left, box.high.y()}}});
    }
  }

  BricksParameters p_;
  Courses courses_;
};

Kind<CourseParameters> course_kind() {
  using P = CourseParameters;
  return Schema<P>("A course of bricks.")
      .numbers(
          "lengths", &P::lengths,
          {.dimension = dimension::length,
           .bounds = above(0),
           .at_least = 0,
           .text = "Lengths of its bricks, one after the other, again and again; else all have `length`."})
      .number("height", &P::height,
              {.dimension = dimension::length, .bounds = above(0), .text = "Its height, if another."})
      .number("offset", &P::offset,
              {.fallback = 0,
               .dimension = dimension::length,
               .text = "How far from `origin` one of its first bricks begins, to the right."})
      .kind();
}

void check(const BricksParameters& p, const Position& where, Findings& findings) {
  const bool has_headers = p.bond == Bond::flemish || p.bond == Bond::english;
  if (p.header && !has_headers) findings.add(where, "'header' belongs to flemish and english bond");
  if (p.overlap && p.bond != Bond::running) findings.add(where, "'overlap' belongs to running bond");
  if (!p.courses.empty() && (p.header || p.overlap || p.bond != Bond::running))
    findings.add(where, "`courses` say how their bricks lie: leave out `bond`, `header` and `overlap`");
}

Schema<BricksParameters> schema() {
  using P = BricksParameters;
  return Schema<P>(
             "Masonry: courses of bricks in a bond, joints of no thickness, cut at the outline; interfaces "
             "and slits are "
             "followed.")
      .number("length", &P::length,
              {.dimension = dimension::length, .bounds = above(0), .text = "Length of a stretcher."})
      .number("height", &P::height,
              {.dimension = dimension::length, .bounds = above(0), .text = "Height of a course."})
      .one_of("bond", &P::bond,
              {{"stack", Bond::stack},
               {"running", Bond::running},
               {"flemish", Bond::flemish},
               {"english", Bond::english}},
              {.fallback = Bond::running,
               .text = "Joints above each other; stretchers that overlap; stretcher and header by turns, "
                       "each header over "
                       "the middle of a stretcher; courses of stretchers and of headers by turns."})
      .number(
          "header", &P::header,
          {.dimension = dimension::length,
           .bounds = above(0),
           .text = "Visible length of a header, of flemish and english bond; half a stretcher if absent."})
      .number("overlap", &P::overlap,
              {.bounds = strictly_between(0, 1),
               .text = "Of running bond: by which part of a length every second course begins earlier; half "
                       "if absent."})
      .point("origin", &P::origin,
             {.text = "Lower left corner of a brick of a course that begins with a whole one; that of each "
                      "region's box if "
                      "absent."})
      .list("courses", &P::courses, course_kind(),
            {.at_least = 0,
             .text = "Instead of a bond: courses from below, one by one, with bricks of any length; behind "
                     "the last the first "
                     "comes again."})
      .check(check);
}

}  // namespace

DDA_REGISTER(subdivisions(), "bricks", schema(), make_of<Bricks>);

}  // namespace dda
