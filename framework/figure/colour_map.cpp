#include "framework/figure/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dda::svg {
namespace {

using Rgb = std::array<double, 3>;

constexpr std::array<Rgb, 9> viridis_stops = {{{68, 1, 84},
                                               {71, 45, 123},
                                               {59, 82, 139},
                                               {44, 114, 142},
                                               {33, 145, 140},
                                               {40, 174, 128},
                                               {94, 201, 98},
                                               {173, 220, 48},
                                               {253, 231, 37}}};
constexpr std::array<Rgb, 5> crack_stops = {
    {{255, 214, 90}, {253, 162, 55}, {236, 98, 38}, {196, 30, 30}, {110, 0, 20}}};
constexpr std::array<Rgb, 5> violet_to_green_stops = {
    {{88, 34, 130}, {166, 130, 196}, {246, 246, 246}, {126, 186, 140}, {10, 96, 60}}};

std::span<const Rgb> stops_of(ColourMap map) {
  if (map == ColourMap::viridis) return viridis_stops;
  return map == ColourMap::crack ? crack_stops : violet_to_green_stops;
}

}  // namespace

std::string colour(ColourMap map, double part) {
  if (std::isnan(part)) return "#d9d9d9";
  const std::span<const Rgb> stops = stops_of(map);
  const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double weight = place - static_cast<double>(first);
  std::array<int, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i) {
    mixed[i] = static_cast<int>(std::lround((1 - weight) * stops[first][i] + weight * stops[first + 1][i]));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

}  // namespace dda::svg
