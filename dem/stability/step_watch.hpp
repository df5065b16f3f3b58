// What a run remembers of its step: the limits it met, and the energy at the last look.
#pragma once

#include <cstdint>
#include <limits>

namespace clogflow {

/// Steps between two looks: a look costs about as much as thirty steps.
inline constexpr std::int64_t look_every = 4096;

/// Steps between two looks at the whole network where the step is near its bound and the contacts have not become
/// stiffer: they may have moved together. It costs about as much as five hundred steps.
inline constexpr std::int64_t look_at_whole_every = 16 * look_every;

struct StepWatch {
  double smallest_bound = std::numeric_limits<double>::infinity();  ///< NetworkLimit::bound() [s]
  double smallest_limit = std::numeric_limits<double>::infinity();  ///< exact() where the bound was near [s]
  bool warned = false, deep = false;  ///< of a step near its limit, of deep overlaps: said once
  double shaking = 0;                 ///< largest speed of a pack that rests at whole steps but not between them [m/s]
  double stored = -1;                 ///< kinetic and elastic energy at the last look; -1: none yet [J]
  double supplied = 0;                ///< work done until then [J]

  /// Energy that nothing supplied since the last look, if it is enough to be a blow-up: more than half of
  /// what is stored, which more than doubled. Rounding and the springs' change of stiffness with the
  /// overlap leave errors far below the 5 % of the work that are granted.
  bool appeared(double stored_now, double supplied_now) {
    const double work = supplied_now - supplied, before = stored;
    stored = stored_now;
    supplied = supplied_now;
    if (before < 0 || !(stored_now > 2 * before)) return false;
    return stored_now - before - work > 0.5 * stored_now + 0.05 * (work < 0 ? -work : work);
  }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(smallest_bound, smallest_limit, warned, deep, shaking, stored, supplied);
  }
};

}  // namespace clogflow
