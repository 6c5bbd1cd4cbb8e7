#pragma once

#include <string>

namespace dda {

/// The two units a deck is written in; every number of the run is in them, nothing is ever converted.
struct Units {
  std::string length = "mm";
  std::string force = "N";
};

/// What a number measures, as powers of force and length: F^force L^length.
struct Dimension {
  int force = 0;
  int length = 0;
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

/// The dimensions that decks and results speak of; a namespace, so that a local `stress` shadows nothing.
namespace dimension {
inline constexpr Dimension none{};               ///< dimensionless
inline constexpr Dimension length{0, 1};         ///< L
inline constexpr Dimension area{0, 2};           ///< L²
inline constexpr Dimension second_moment{0, 4};  ///< L⁴
inline constexpr Dimension curvature{0, -1};     ///< 1/L
inline constexpr Dimension force{1, 0};          ///< F
inline constexpr Dimension stress{1, -2};        ///< F/L², also an elastic modulus or an edge traction
inline constexpr Dimension stiffness{1, -1};     ///< F/L, a spring
inline constexpr Dimension interface_stiffness{1, -3};  ///< F/L³, traction per opening
inline constexpr Dimension energy_per_area{1, -1};      ///< F/L, fracture energy
inline constexpr Dimension body_force{1, -3};           ///< F/L³
inline constexpr Dimension moment{1, 1};                ///< F·L
inline constexpr Dimension energy{1, 1};                ///< F·L
}  // namespace dimension

/// The unit of a dimension: "N/mm", "N·mm", "mm²"; "-" when dimensionless.
///
/// A stress in N and mm, N and m, kN and m or MN and m has its own name: "MPa", "Pa", "kPa", "MPa".
std::string label(Dimension dimension, const Units& units);

/// The same without units, as in a manual: "F/L²".
std::string label(Dimension dimension);

}  // namespace dda
