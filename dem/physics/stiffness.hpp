// Stiffness and damping of one contact as the time step feels them, and the step that a mode allows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dem/physics/friction.hpp"

namespace clogflow {

/// Largest stable step of one mode of the leapfrog scheme with forces at the velocity half a step back:
///   x_(n+1) - 2 x_n + x_(n-1) + (w dt)^2 x_n + g dt (x_n - x_(n-1)) = 0
/// is stable while (w dt)^2 + 2 g dt <= 4, so
///   dt = 4 / (g + sqrt(g^2 + 4 w^2)):  2 / w without damping, 2 / g without stiffness.
/// \param stiffness  w^2 = k / m [1/s2];  \param damping g = c / m [1/s]
/// \return [s]; infinite when both are zero
/// \source Jury's conditions on the characteristic polynomial l^2 - (2 - K - C) l + 1 - C
inline double stable_step(double stiffness, double damping) {
  return 4 / (damping + std::sqrt(damping * damping + 4 * stiffness));
}

/// One elastic direction of a contact.
struct ContactMode {
  double stiffness;     ///< [N/m]
  double dashpot;       ///< [N s/m]
  Vec3 shift;           ///< velocity per velocity of i (of j: the opposite) [-]
  Vec3 turn_i, turn_j;  ///< velocity per spin of i and of j [m]
};

/// Tangents of the six springs of a contact: normal, sliding x 2, rolling x 2, torsion. Stretch rates are
///   v_n = n.(u_i - u_j);  v_t = t.(u_i - u_j) - (a_i w_i + a_j w_j).(n x t);
///   v_r = -R* (n x (w_i - w_j)).t;  v_o = 2 R* n.(w_i - w_j)
/// with the normal law's own tangent and k_t of the others. A slider that slips is softer, so this
/// bounds it from above.
/// \return as many of the six as `terms` switches on
/// \source derivative of contact_loads()
struct ContactModes {
  std::array<ContactMode, 6> mode;
  int count = 0;
};

template <class Turning, class NormalLaw>
ContactModes contact_modes(const NormalLaw& law, const ContactTerms& terms, const ContactGeometry<double>& g) {
  const NormalTangent normal = law.tangent(g);
  const NormalResponse<double> response = law.respond(g, 0.0);
  const double tangential = response.stiffness, tangential_dashpot = response.dashpot;
  const double turning = Turning::full_stiffness ? tangential / law.tangential_factor : tangential;
  const double lever = Turning::rolling_lever * g.radius;
  const Vec3& n = g.normal;
  const Vec3 none{0, 0, 0};
  const Vec3 least = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 across = cross(n, least);
  const Vec3 s = (1 / std::sqrt(dot(across, across))) * across, t = cross(n, s);

  ContactModes modes;
  const auto add = [&](const ContactMode& mode) { modes.mode[modes.count++] = mode; };
  add({normal.stiffness, normal.dashpot, n, none, none});
  if (terms.sliding) {
    add({tangential, tangential_dashpot, s, -g.arm_i * t, -g.arm_j * t});
    add({tangential, tangential_dashpot, t, g.arm_i * s, g.arm_j * s});
  }
  if (terms.rolling) {
    add({turning, tangential_dashpot, none, lever * s, -lever * s});
    add({turning, tangential_dashpot, none, lever * t, -lever * t});
  }
  if (terms.torsion) add({turning, tangential_dashpot, none, 2 * g.radius * n, -2 * g.radius * n});
  return modes;
}

}  // namespace clogflow
