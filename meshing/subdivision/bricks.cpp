#include <cmath>

#include "meshing/geometry/voronoi.hpp"
#include "meshing/room.hpp"
#include "meshing/subdivision/parts.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

enum class Bond { stack, running, flemish, english };

struct BricksParameters {
  double length = 0, height = 0;
  std::optional<double> header, overlap;
  Bond bond = Bond::running;
  std::optional<Vec2> origin;
  Position where;
};

/// A course: bricks of these lengths one after the other, again and again, one of which begins at `start`.
struct Course {
  std::vector<double> lengths;
  double start = 0;

  double period() const {
    double sum = 0;
    for (const double length : lengths) sum += length;
    return sum;
  }
};

/// Courses of bricks whose joints have no thickness, cut at the outline.
class Bricks final : public Subdivision {
 public:
  explicit Bricks(BricksParameters parameters) : p_(std::move(parameters)) {}

  Cells divide(const Layout& layout) const override {
    if (layout.model) require_sound(layout);
    require_room(area_of(layout) / (p_.height * std::min(p_.length, header())), p_.where);
    const std::vector<LayoutPart> parts = parts_of(layout);
    return cells_of_parts(layout, parts, [&](std::size_t i) {
      const Vec2 origin = p_.origin.value_or(box_of_region(layout, parts[i].region).low);
      return cells_in(parts[i].figure, pattern(origin, bounding_box(parts[i].figure.outline.vertices)),
                      std::min(p_.height, header()));
    });
  }

 private:
  double header() const { return p_.header.value_or(p_.length / 2); }

  static Box box_of_region(const Layout& layout, int region) {
    Box out;
    for (const Shape& shape : layout.shapes)
      if (shape.region == region)
        for (const Vec2& corner : shape.figure.outline.vertices) out.include(corner);
    return out;
  }

  /// Of the course above an even or an odd number of others.
  Course course(bool is_odd) const {
    switch (p_.bond) {
      case Bond::stack:
        return {{p_.length}, 0};
      case Bond::running:
        return {{p_.length}, is_odd ? -p_.overlap.value_or(0.5) * p_.length : 0};
      case Bond::flemish:
        return {{p_.length, header()}, is_odd ? -(p_.length + header()) / 2 : 0};
      case Bond::english:
        return is_odd ? Course{{header()}, -header() / 2} : Course{{p_.length}, 0};
    }
    return {};
  }

  std::vector<Polygon> pattern(const Vec2& origin, const Box& box) const {
    std::vector<Polygon> bricks;
    const auto first = static_cast<std::int64_t>(std::floor((box.low.y() - origin.y()) / p_.height));
    for (std::int64_t j = first; origin.y() + static_cast<double>(j) * p_.height < box.high.y(); ++j) {
      const double low = origin.y() + static_cast<double>(j) * p_.height,
                   high = origin.y() + static_cast<double>(j + 1) * p_.height;
      add_course(course(j % 2 != 0), origin.x(), {{box.low.x(), low}, {box.high.x(), high}}, bricks);
    }
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
};

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
      .check([](const P& p, const Position& where, Findings& findings) {
        const bool has_headers = p.bond == Bond::flemish || p.bond == Bond::english;
        if (p.header && !has_headers) findings.add(where, "'header' belongs to flemish and english bond");
        if (p.overlap && p.bond != Bond::running) findings.add(where, "'overlap' belongs to running bond");
      });
}

}  // namespace

DDA_REGISTER(subdivisions(), "bricks", schema(), make_of<Bricks>);

}  // namespace dda
