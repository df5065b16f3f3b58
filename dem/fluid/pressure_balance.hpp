// What particles make a pump pay: the pressure drop over a channel with them in its flow.
#pragma once

#include <cmath>

#include "dem/kernels/kernels.hpp"

namespace clogflow {

/// The channel without particles.
struct ChannelResistance {
  double pressure_drop = 0;  ///< of V0, from inlet to outlet [Pa]
  double flow_rate = 0;      ///< Q0 of V0 [m3/s]
};

/// What the particles add: their forces on the flow q V0, weighted with V0, are resistance q - push [W].
struct ParticleResistance {
  double resistance = 0;  ///< sum of s c |V0|^2
  double push = 0;        ///< sum of s c V0 . (v + r F)
};

/// Sums over the particles as a step will move them. The fluid's force on one is F_i = c (q V0 - v') at the velocity v'
/// that the step leads to; with r = dt / m and all other forces F on it
///   v' = (v + r (F + c q V0)) / (1 + r c),  so  F_i . V0 = s c (q V0^2 - V0 . (v + r F)),  s = 1 / (1 + r c)
/// which is linear in q: q and all v' are solved together, as the rank-one system that they are. With explicit drag the
/// force is at v: s = 1, r = 0. Torques count in the same way, with half the curl of V0 and the spins.
/// \param step  what advance() is given, with V0 in the place of the fluid's velocity
ParticleResistance resistance_of(const AdvanceTask& step);

/// The 0-D balance of pressures of a flow q V0(x) that keeps its shape:
///   Delta p = q Delta p0 + (1 / Q0) sum of F_i . V0(x_i)
/// from Lorentz' reciprocal theorem between the flow with the particles' point forces and V0: both vanish at the walls,
/// and each does work against the other's pressure at the openings. Exact for point forces in Stokes flow between
/// openings of developed flow; the drag law stands for what particles do to each other. Neglects the fluid's inertia.
/// \source H. Brenner, Phys. Fluids 1 (1958) 338, "Dissipation of energy due to solid particles suspended in a viscous
///         liquid", and J. Fluid Mech. 43 (1970) 641: the additional pressure drop of particles in a duct; J. Happel &
///         H. Brenner, Low Reynolds Number Hydrodynamics
class PressureBalance {
public:
  PressureBalance() = default;

  /// \param compliance  0: the pressure is given [m3/Pa]
  PressureBalance(const ChannelResistance& channel, double compliance) : channel_(channel), compliance_(compliance) {}

  /// q of a pressure drop. \param drop  [Pa]
  double factor(const ParticleResistance& particles, double drop) const {
    return (drop + push(particles)) / slope(particles);
  }

  /// The pressure drop that makes a q [Pa]
  double drop(const ParticleResistance& particles, double factor) const {
    return slope(particles) * factor - push(particles);
  }

  /// A pump of the rate k Q0 feeds a volume that stores C Delta p:  C d(Delta p)/dt = (k - q) Q0.
  /// Exact over a step in which the particles' resistance stays: Delta p relaxes towards that of q = k with
  /// C (Delta p0 / Q0 + sum). \return the mean q of the step; `drop` becomes that after it
  double relax(const ParticleResistance& particles, double pump, double dt, double& drop) const {
    const double end = this->drop(particles, pump);
    const double time = compliance_ * slope(particles) / channel_.flow_rate;
    const double change = (drop - end) * std::expm1(-dt / time);
    drop += change;
    return pump - compliance_ * change / (channel_.flow_rate * dt);
  }

  bool is_compliant() const { return compliance_ > 0; }

private:
  double slope(const ParticleResistance& p) const { return channel_.pressure_drop + p.resistance / channel_.flow_rate; }
  double push(const ParticleResistance& p) const { return p.push / channel_.flow_rate; }

  ChannelResistance channel_;
  double compliance_ = 0;
};

}  // namespace clogflow
