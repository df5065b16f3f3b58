// Two materials in contact: effective moduli, and the dashpot that gives a restitution.
#pragma once

namespace clogflow {

struct Material {
  double youngs_modulus;  ///< E [Pa] > 0
  double poisson_ratio;   ///< nu [-], in (-1, 0.5]
};

/// E* of two elastic bodies: 1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b.
/// For equal materials E / (2 (1 - nu^2)).
/// \return [Pa]
/// \source paper, text below Eq. (1); K. L. Johnson, Contact Mechanics, Eq. (4.20)
double effective_modulus(const Material& a, const Material& b);

/// G* of two elastic bodies: 1/G* = (2 - nu_a)/G_a + (2 - nu_b)/G_b with G = E / (2 (1 + nu)).
/// For equal materials G / (2 (2 - nu)).
/// \return [Pa]
/// \source K. L. Johnson, Contact Mechanics, Eq. (7.43)
double effective_shear_modulus(const Material& a, const Material& b);

/// Damping ratio zeta of a linear oscillator whose half swing gives the restitution e, if the contact is lost
/// when the force has fallen to zero, so that it never pulls.
///   e = exp(-(pi - 2 phi) tan phi),  zeta = sin phi        (e > exp(-2))
///   e = exp(-2 psi coth psi),        zeta = cosh psi       (e <= exp(-2))
/// \param restitution  e [-], in (0, 1]
/// \return zeta [-]
/// \throws Error outside (0, 1]
/// \source Schwager & Poeschel, Granular Matter 9 (2007) 465
double damping_ratio(double restitution);

/// Damping constant gamma of the force -gamma sqrt(m* k) v_n (k the Hertz secant stiffness) that gives a dry
/// head-on impact the restitution e: gamma = sqrt(5) zeta(e).
/// With u = delta^(5/4) and d(tau) = delta^(1/4) dt the Hertz impact is a damped linear oscillator of damping
/// ratio gamma / sqrt(5).
/// \source Antypov & Elliott, EPL 94 (2011) 50004
double damping_constant(double restitution);

}  // namespace clogflow
