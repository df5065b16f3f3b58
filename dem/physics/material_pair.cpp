#include "dem/physics/material_pair.hpp"

#include <cmath>
#include <numbers>

#include <boost/math/tools/roots.hpp>

#include "coupling/base/require.hpp"

namespace clogflow {

double effective_modulus(const Material& a, const Material& b) {
  const auto compliance = [](const Material& m) { return (1 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus; };
  return 1 / (compliance(a) + compliance(b));
}

double effective_shear_modulus(const Material& a, const Material& b) {
  const auto compliance = [](const Material& m) {
    const double shear_modulus = m.youngs_modulus / (2 * (1 + m.poisson_ratio));
    return (2 - m.poisson_ratio) / shear_modulus;
  };
  return 1 / (compliance(a) + compliance(b));
}

double damping_ratio(double restitution) {
  require(restitution > 0 && restitution <= 1, "contact.restitution = {} (must be in (0, 1])", restitution);
  if (restitution == 1) return 0;
  const double decay = -std::log(restitution);
  const boost::math::tools::eps_tolerance<double> full_precision(52);
  std::uintmax_t iterations = 200;
  // Beyond restitution exp(-2) the oscillator is overdamped; both branches are monotonic.
  if (decay < 2) {
    const auto excess = [&](double phi) { return (std::numbers::pi - 2 * phi) * std::tan(phi) - decay; };
    const auto [low, high] =
        boost::math::tools::bisect(excess, 0.0, std::numbers::pi / 2 - 1e-9, full_precision, iterations);
    return std::sin((low + high) / 2);
  }
  const auto excess = [&](double psi) { return 2 * psi / std::tanh(psi) - decay; };
  const auto [low, high] = boost::math::tools::bisect(excess, 1e-9, decay, full_precision, iterations);
  return std::cosh((low + high) / 2);
}

double damping_constant(double restitution) { return std::sqrt(5.0) * damping_ratio(restitution); }

}  // namespace clogflow
