// Characteristic times of a contact.
#pragma once

#include <cmath>
#include <numbers>

namespace clogflow {

/// A typical collision of two equal spheres, whatever their law.
struct Impact {
  double density;   ///< rho of the particle, mass scale included [kg/m3]
  double diameter;  ///< d [m]
  double speed;     ///< v_c typical collision velocity [m/s]
};

/// What Hertz' contact time needs to know.
struct CollisionScales {
  double density;            ///< rho of the particle, mass scale included [kg/m3]
  double effective_modulus;  ///< E* [Pa]
  double diameter;           ///< d [m]
  double speed;              ///< v_c typical collision velocity [m/s]
};

/// Share of the mean flow velocity that the paper takes as the typical collision velocity.
inline constexpr double collision_speed_share = 0.1;

/// Duration of a Hertz collision, dry and elastic.
///   tau_Hertz = 2.214 (rho / E*)^(2/5) d / v_c^(1/5)
/// \return [s]
/// \source paper Eq. (2)
inline double hertz_contact_time(const CollisionScales& c) {
  return 2.214 * std::pow(c.density / c.effective_modulus, 0.4) * c.diameter / std::pow(c.speed, 0.2);
}

/// Time that a Rayleigh surface wave takes around a sphere: pi r sqrt(rho / G) / (0.1631 nu + 0.8766).
/// \param shear_modulus G of the particle material [Pa]
/// \return [s]
/// \source Li, Xu & Thornton, Powder Technol. 160 (2005) 219
inline double rayleigh_time(double radius, double density, double shear_modulus, double poisson) {
  return std::numbers::pi * radius * std::sqrt(density / shear_modulus) / (0.1631 * poisson + 0.8766);
}

}  // namespace clogflow
