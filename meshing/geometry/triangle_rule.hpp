#pragma once

#include "meshing/geometry/polygon.hpp"

namespace dda {

/// ∫ f dA over a simple polygon of a polynomial f of degree up to four, by six points in each of the triangles
/// (centre, vᵢ, vᵢ₊₁), which count with the sign of their area. `add(weight, x)` is called at each point.
template <class Add>
void for_each_quadrature_point(const Polygon& polygon, const Vec2& centre, Add add) {
  struct Orbit {
    double weight, twice, once;  // barycentric coordinates (twice, twice, once)
  };
  constexpr Orbit orbits[] = {{0.22338158967801146570, 0.44594849091596488632, 0.10810301816807022736},
                              {0.10995174365532186764, 0.09157621350977074346, 0.81684757298045851308}};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 corners[] = {centre, polygon.at(i), polygon.at(i + 1)};
    const double area = cross(corners[1] - centre, corners[2] - centre) / 2;
    for (const Orbit& orbit : orbits)
      for (std::size_t k = 0; k < 3; ++k)
        add(orbit.weight * area,
            Vec2(orbit.once * corners[k] + orbit.twice * (corners[(k + 1) % 3] + corners[(k + 2) % 3])));
  }
}

}  // namespace dda
