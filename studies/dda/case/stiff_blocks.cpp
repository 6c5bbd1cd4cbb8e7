#include "studies/dda/case/stiff_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace dda {
namespace {

/// Of a material.
struct Blocks {
  double contraction = 0;
  std::size_t of_first_order = 0,
              with_corners = 0;  ///< the latter of second order, with more than three corners
};

}  // namespace

std::vector<std::string> stiff_blocks(const Body& body) {
  static constexpr double nearly = 0.45, all_but = 0.495;
  const auto is_stiff = [](const auto& material) { return material->held_contraction() > nearly; };
  if (std::ranges::none_of(body.materials, is_stiff)) return {};
  std::map<std::string, Blocks> found;
  for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b) {
    const Block& block = body.block(BlockId{b});
    Blocks& of = found[body.assembly.regions[static_cast<std::size_t>(block.region)].material];
    of.contraction = body.material(BlockId{b}).held_contraction();
    const bool is_second = body.gradient_of(BlockId{b}).has_value();
    of.of_first_order += is_second ? 0 : 1;
    of.with_corners += is_second && block.outline.size() > 3 ? 1 : 0;
  }
  std::vector<std::string> out;
  for (const auto& [name, of] : found) {
    if (of.contraction > nearly && of.of_first_order > 1)
      out.push_back(fmt::format(
          "the volume of '{}' hardly changes (Poisson's ratio {:g} in plane strain), and {} of its blocks "
          "are of first order: "
          "they are far too stiff in bending; take `kinematics: second_order`{}",
          name, of.contraction, of.of_first_order, of.contraction > all_but ? " on triangles" : ""));
    if (of.contraction > all_but && of.with_corners > 1)
      out.push_back(fmt::format(
          "the volume of '{}' all but stays (Poisson's ratio {:g} in plane strain): blocks of second order "
          "with more than three "
          "corners are too stiff for that, and their stresses are wrong; take `subdivision: triangles`",
          name, of.contraction));
  }
  return out;
}

}  // namespace dda
