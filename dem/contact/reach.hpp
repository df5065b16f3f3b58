// How far a pair list looks.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/kernels/kernels.hpp"

namespace clogflow {

/// Lists hold until a particle has gone farther than its room. The few that are fast, in the neck, have more of it
/// than the many that are not: so they do not force new lists for all, and the lists do not look farther for all.
struct Reach {
  double skin = 0;         ///< two particles of the widest room may together drift this far before a rebuild [m]
  double lubrication = 0;  ///< largest gap at which a film or a contact that sticks acts; 0: none [m]
  double per_radius = 0;   ///< where sizes differ the same over R*; 0: `lubrication` for all [-]
  bool by_size = false;    ///< sizes differ by scene: small ones are not looked for as far as large ones
  double least_room =
      std::numeric_limits<double>::infinity();  ///< of a particle that stands; infinite: as the widest [m]
  double hold_time = 0;                         ///< for which a particle's present speed is room for [s]

  /// Largest distance of two centres at which they may act on each other; grows with either radius [m].
  double contact(double a, double b) const {
    return a + b + (per_radius > 0 ? per_radius * a * b / (a + b) : lubrication);
  }

  /// Largest distance of two centres that must be listed, if both have the widest room [m].
  double of(double a, double b) const { return contact(a, b) + skin; }

  /// How far a particle may go before a rebuild [m].
  double room(const ParticleState& p) const {
    const double expected = hold_time * std::sqrt(p.vx * p.vx + p.vy * p.vy + p.vz * p.vz);
    return std::min(std::max(expected, least_room), skin / 2);
  }
};

}  // namespace clogflow
