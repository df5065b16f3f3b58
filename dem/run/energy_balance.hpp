// What a run was given, so that what it dissipated is the rest.
#pragma once

#include <cmath>

namespace clogflow {

/// Energy that came into the particles from outside. What the contacts and films did with it, each on its own, is in
/// energy_account.hpp.
struct EnergyBalance {
  double drag_work = 0, body_work = 0;  ///< since the start, or since the gate opened [J]
  double brought = 0;  ///< kinetic and elastic energy at the first sample, and of what came and went [J]

  double supplied() const { return drag_work + body_work + brought; }

  /// Work counts from now.
  void restart() { drag_work = body_work = 0; }

  bool valid() const { return std::isfinite(drag_work) && std::isfinite(body_work) && std::isfinite(brought); }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(drag_work, body_work, brought);
  }
};

}  // namespace clogflow
