#include <fmt/format.h>

#include <algorithm>

#include "continuation/handover/regions.hpp"
#include "framework/figure/style.hpp"
#include "studies/dda/figures/model_marks.hpp"

namespace dda {
namespace {

using svg::KeyEntry;
using svg::Mark;

constexpr int green = 2;  ///< place in the palette

class MotionMarks {
 public:
  explicit MotionMarks(const ModelDrawing& to)
      : to_(to), body_(to.simulation.body()), motion_(*to.simulation.deck().motion) {}

  void add() {
    add_held();
    add_driven();
    add_thrown();
    add_gravity();
  }

 private:
  const std::vector<Block>& blocks() const { return body_.assembly.blocks; }
  void add_key(KeyEntry::Kind kind, int colour, std::string name) {
    to_.drawing.key.push_back({kind, colour, std::move(name)});
  }

  void add_held() {
    bool is_any = false;
    for (std::size_t b = 0; b < blocks().size(); ++b) {
      const bool is_this = is_held(body_, motion_, blocks()[b].region);
      to_.drawing.polygons[b].is_held = is_this;
      is_any = is_any || is_this;
    }
    if (is_any) add_key(KeyEntry::Kind::hatching, 0, "held in the motion, or moved as prescribed");
  }

  /// Of the blocks of some regions.
  Middle middle_of(const std::vector<std::string>& regions) const {
    Middle out;
    for (const Block& block : blocks())
      if (is_named(regions, body_, block.region)) out.include(block);
    return out;
  }

  void add_driven() {
    for (const DriveParameters& drive : motion_.driven)
      to_.drawing.symbols.push_back(
          {Mark::moved, middle_of(drive.regions).place(), drive.direction, svg::vermilion, {}});
    if (!motion_.driven.empty()) add_key(KeyEntry::Kind::moved, svg::vermilion, "motion prescribed");
  }

  /// Each region turns about a place of its own.
  void add_thrown() {
    for (const VelocityParameters& thrown : motion_.velocities)
      for (const std::string& region : thrown.regions) {
        const Vec2 at = middle_of({region}).place();
        to_.drawing.symbols.push_back({Mark::moved, at, thrown.velocity, green, {}});
        if (thrown.spin != 0) to_.drawing.symbols.push_back({Mark::turned, at, Vec2::UnitX(), green, {}});
      }
    if (!motion_.velocities.empty()) add_key(KeyEntry::Kind::moved, green, "velocity at the beginning");
  }

  void add_gravity() {
    const double size = motion_.gravity.norm();
    if (size == 0) return;
    Middle moving;
    for (const Block& block : blocks())
      if (!is_held(body_, motion_, block.region)) moving.include(block);
    to_.drawing.symbols.push_back({Mark::force, moving.place(), motion_.gravity, svg::black, "g"});
    add_key(KeyEntry::Kind::force, svg::black,
            fmt::format("g = {:.4g} {}/s², of what moves", size, to_.simulation.deck().units.length));
  }

  const ModelDrawing& to_;
  const Body& body_;
  const MotionParameters& motion_;
};

}  // namespace

void add_motion(const ModelDrawing& to) {
  if (to.simulation.deck().moves()) MotionMarks(to).add();
}

}  // namespace dda
