// How far a pair list looks.
#pragma once

namespace clogflow {

struct Reach {
  double skin = 0;         ///< two particles may together drift this far before a rebuild [m]
  double lubrication = 0;  ///< largest gap at which a film or a contact that sticks acts; 0: none [m]
  double per_radius = 0;   ///< where sizes differ the same over R*; 0: `lubrication` for all [-]
  bool by_size = false;    ///< sizes differ by scene: small ones are not looked for as far as large ones

  /// Largest distance of two centres that must be listed; grows with either radius [m].
  double of(double a, double b) const {
    return a + b + skin + (per_radius > 0 ? per_radius * a * b / (a + b) : lubrication);
  }
};

}  // namespace clogflow
