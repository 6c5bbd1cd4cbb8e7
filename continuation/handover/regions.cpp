#include "continuation/handover/regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "meshing/contact/outline.hpp"

namespace dda {

bool is_named(const std::vector<std::string>& regions, const Body& body, int region) {
  return std::ranges::find(regions, body.assembly.regions[static_cast<std::size_t>(region)].name) !=
         regions.end();
}

bool is_held(const Body& body, const MotionParameters& parameters, int region) {
  return is_named(parameters.held, body, region) ||
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
