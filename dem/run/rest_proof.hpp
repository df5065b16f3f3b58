// Is a clog at rest for good? Under a steady drive what stands still on all sides stays so.
#pragma once

#include "dem/run/run_state.hpp"

namespace clogflow {

/// Whether nothing can break the clog any more, by looking at the whole column upstream of the passage plane:
///   speeds    99 of 100 particles slower than rest_speed_share, and none faster than rattler_share, of the flow's
///   speed forces    the net force on 99 of 100 is below rest_force_share of what drives a lone one: the Stokes drag of
///   the flow
///             and the body force
///   inlet     no room for a particle in any attempt of the last Stokes time
///   drive     neither fluctuation nor pulsation, and no oscillation to come; friction on
/// In a pack at rest speeds fall exponentially, from a thousandth of the flow's to rounding within a few tau, so
/// what is that slow has stopped. A rattler may still creep through its cage; it carries no load. Neglects that a
/// later particle finds room at the inlet after all and adds its drag to the column: with the walls' friction a
/// distant arch hardly feels it. Tested against runs that go on (tests/dem/run/test_rest_proof.cpp).
/// After compute_forces().
bool rests_for_good(const RunState& state);

/// Shares of the speed of the flow, and of the Stokes drag in it [-].
inline constexpr double rest_speed_share = 1e-5, rest_force_share = 1e-5, rattler_share = 1e-2;

}  // namespace clogflow
