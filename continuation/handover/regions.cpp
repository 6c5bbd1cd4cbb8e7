#include "continuation/handover/regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "meshing/contact/outline.hpp"
#include "meshing/geometry/geos.hpp"

namespace dda {
namespace {

/// Whether joints that cannot tear hold all blocks together.
bool are_held_together(std::size_t num_blocks, const InterfaceSet& interfaces) {
  std::vector<std::vector<std::size_t>> beside(num_blocks);
  for (const InterfacePoint& point : interfaces.points) {
    if (point.law->can_crack() || point.is_separate()) continue;
    beside[point.first.value()].push_back(point.second.value());
    beside[point.second.value()].push_back(point.first.value());
  }
  std::vector<bool> is_reached(num_blocks, false);
  std::vector<std::size_t> reached{0};
  is_reached[0] = true;
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const std::size_t other : beside[reached[next]])
      if (!is_reached[other]) {
        is_reached[other] = true;
        reached.push_back(other);
      }
  return reached.size() == num_blocks;
}

}  // namespace

bool is_named(const std::vector<std::string>& regions, const Body& body, int region) {
  return std::ranges::find(regions, body.assembly.regions[static_cast<std::size_t>(region)].name) !=
         regions.end();
}

bool is_held(const Body& body, const MotionParameters& parameters, int region) {
  return is_named(parameters.held.names, body, region) ||
         std::ranges::any_of(parameters.driven, [&](const DriveParameters& drive) {
           return is_named(drive.regions, body, region);
         });
}

std::optional<double> friction_of_others(const InterfaceSet& interfaces, const MotionParameters& parameters) {
  if (parameters.contact.friction) return parameters.contact.friction;
  std::optional<double> out;
  for (const InterfacePoint& point : interfaces.points)
    if (const auto residual = point.law->residual_friction()) {
      if (out && *out != *residual) return {};
      out = residual;
    }
  return out;
}

bool pairs_tell_all(const Body& body, const MotionParameters& parameters) {
  constexpr int of_cut = 2;  // parts of a block may meet each other
  std::map<std::string, int> moving, all;
  for (const Block& block : body.assembly.blocks) {
    const std::string& material = body.assembly.regions[static_cast<std::size_t>(block.region)].material;
    const int parts = body.cracks ? of_cut : 1;
    all[material] += parts;
    if (!is_held(body, parameters, block.region)) moving[material] += parts;
  }
  const auto tells = [&](const std::string& a, const std::string& b) {
    return std::ranges::any_of(parameters.contact.pairs, [&](const PairParameters& pair) {
      return pair.friction && std::ranges::is_permutation(pair.between, std::vector{a, b});
    });
  };
  for (const auto& [material, parts] : moving)
    for (const auto& [other, there] : all)
      if ((material != other || there > 1) && !tells(material, other)) return false;
  return true;
}

bool is_one_convex_body(const Body& body, const InterfaceSet& interfaces) {
  constexpr double rounding = 1e-9;
  if (body.cracks || !are_held_together(body.assembly.num_blocks(), interfaces)) return false;
  double area = 0;
  std::vector<Vec2> corners;
  for (const Block& block : body.assembly.blocks) {
    area += block.moments.area;
    corners.insert(corners.end(), block.outline.vertices.begin(), block.outline.vertices.end());
  }
  return hull_area(corners) <= (1 + rounding) * area;
}

double smallest_size(const Assembly& assembly) {
  double out = std::numeric_limits<double>::infinity();
  for (const Block& block : assembly.blocks) out = std::min(out, std::sqrt(block.moments.area));
  return out;
}

double offset_of(const Body& body, const MotionParameters& parameters) {
  return parameters.contact.offset * smallest_size(body.assembly);
}

std::optional<std::string> too_narrow(const Assembly& assembly, double offset) {
  for (std::size_t b = 0; b < assembly.num_blocks(); ++b) {
    try {
      core_of(assembly.blocks[b].outline, offset);
    } catch (const std::domain_error& error) {
      const Vec2& at = assembly.blocks[b].moments.centroid;
      return fmt::format("block {} at ({:.4g}, {:.4g}) is {}", b, at.x(), at.y(), error.what());
    }
  }
  return {};
}

}  // namespace dda
