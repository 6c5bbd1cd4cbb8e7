#include "models/material/material.hpp"

namespace dda {
namespace {

struct LinearElasticParameters {
  double young_modulus = 0;
  double poisson_ratio = 0;
  double density = 0;
};

/// Isotropic linear elasticity.
///
///     plane stress:  C = E/(1−ν²) [1 ν 0; ν 1 0; 0 0 (1−ν)/2]
///     plane strain:  the same with E → E/(1−ν²), ν → ν/(1−ν)
///
/// Out of the plane, where ε0z is a free strain,
///
///     plane stress:  εz = −ν/(1−ν) (εx + εy) + ε0z
///     plane strain:  σz = Eν/((1+ν)(1−2ν)) (εx + εy) − E ε0z = ν (σx + σy) − E ε0z
class LinearElastic final : public Material {
 public:
  LinearElastic(const LinearElasticParameters& p, Plane plane) : p_(p), plane_(plane) {}

  Mat3 stiffness() const override {
    const bool strain = plane_ == Plane::strain;
    const double nu = strain ? p_.poisson_ratio / (1 - p_.poisson_ratio) : p_.poisson_ratio;
    const double e = strain ? p_.young_modulus / (1 - p_.poisson_ratio * p_.poisson_ratio) : p_.young_modulus;
    Mat3 c;
    c << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
    return e / (1 - nu * nu) * c;
  }
  double modulus() const override { return p_.young_modulus; }
  double held_contraction() const override { return plane_ == Plane::strain ? p_.poisson_ratio : 0; }
  Plane plane() const override { return plane_; }
  Vec3 out_of_plane() const override {
    const double nu = p_.poisson_ratio;
    const double each =
        plane_ == Plane::strain ? p_.young_modulus * nu / ((1 + nu) * (1 - 2 * nu)) : -nu / (1 - nu);
    return {each, each, 0};
  }
  double out_of_plane_by_free_strain() const override {
    return plane_ == Plane::strain ? -p_.young_modulus : 1;
  }
  double density() const override { return p_.density; }

 private:
  LinearElasticParameters p_;
  Plane plane_;
};

Schema<LinearElasticParameters> schema() {
  using P = LinearElasticParameters;
  return Schema<P>("Isotropic linear elasticity.")
      .number("young_modulus", &P::young_modulus,
              {.dimension = dimension::stress, .bounds = above(0), .text = "Young's modulus E."})
      .number("poisson_ratio", &P::poisson_ratio,
              {.fallback = 0.2, .bounds = strictly_between(-1, 0.5), .text = "Poisson's ratio ν."})
      .number("density", &P::density,
              {.fallback = 0,
               .bounds = at_least(0),
               .text = "Density, for `motion` and frequencies alone, in force · s²/length⁴: 2.4e-9 for "
                       "concrete in N and mm; 0 is "
                       "none."});
}

}  // namespace

DDA_REGISTER(materials(), "linear_elastic", schema(), make_of<LinearElastic>);

}  // namespace dda
