// What the next step depends on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "coupling/base/random_stream.hpp"
#include "coupling/base/team.hpp"
#include "dem/fluid/films.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/kernels/kernels.hpp"
#include "dem/protocol/clog_watch.hpp"
#include "dem/protocol/filling.hpp"
#include "dem/protocol/supply_watch.hpp"
#include "dem/run/computing_time.hpp"
#include "dem/run/contact_lists.hpp"
#include "dem/run/energy_balance.hpp"
#include "dem/run/inlet.hpp"
#include "dem/run/kept_column.hpp"
#include "dem/run/model.hpp"
#include "dem/stability/step_watch.hpp"
#include "dem/state/particles.hpp"
#include "dem/state/step_clock.hpp"

namespace clogflow {

/// A run between two steps, but for what it recorded; and what the last forces showed.
struct RunState {
  /// \param constant  must outlive the state
  RunState(const Model& constant, Fluid surrounding, std::uint64_t seed, const std::vector<Particle>& initial,
           int threads = 1);
  RunState(const RunState&) = delete;
  RunState& operator=(const RunState&) = delete;

  const Model& model;
  const std::uint64_t seed;
  Team team;  ///< decides nothing but the time that a step takes
  StepClock clock;
  RandomStream random;
  Inlet inlet;
  Filling filling;
  ClogWatch clog_watch;
  SupplyWatch supply_watch;
  Particles particles;
  ContactLists lists;
  KeptColumn column;  ///< of a restart that goes back
  Fluid fluid;
  double next_insertion = 0, next_porosity = 0;  ///< when due [s]
  double particle_steps = 0;                     ///< done
  EnergyBalance energy;
  StepWatch step_watch;
  ComputingTime computing_time;

  ContactTally pair_tally, wall_tally;  ///< of the last forces
  /// Loads that nothing has used yet are cleared before they are summed anew; the kick clears what it uses.
  bool loads_are_clear = false;

  double time() const { return clock.time(); }
  /// Of waits and durations, which count in what the flow carries: the run's own where the flow is steady [s]
  double flow_time() const { return fluid.drive().flow_time(time()); }
  std::size_t count() const { return particles.size(); }
  double largest_overlap() const {  ///< [m]
    return std::max(pair_tally.largest_overlap, wall_tally.largest_overlap);
  }

  /// Friction is off in parts of the filling, in a release and in a restart.
  bool has_friction() const { return filling.has_friction() && !clog_watch.friction_off(); }

  /// Whether the run is over before time.end.
  bool ended() const { return clog_watch.stopped() || supply_watch.drained(); }

  /// Particles that ever left the channel.
  std::int64_t gone() const { return inlet.numbered() - static_cast<std::int64_t>(count()); }

  /// A contact law as it is now.
  ContactLaw present(ContactLaw law) const {
    if (has_friction()) return law;
    const double region = model.scene.unclog.region;
    if (region > 0 && clog_watch.friction_off())
      law.friction.ends = -region * model.scene.geometry.neck_width;
    else
      law.friction = {};
    return law;
  }

  /// Puts the walls in place that the stage of the filling asks for.
  void place_walls();

  /// Whether what was read from a saved state is one that a run can have. \return nullptr, or the part that is damaged
  const char* damaged_part() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(filling);
    // What was saved of the contacts belongs to these walls.
    if (Archive::loading && filling.gate_is_closed()) place_walls();
    archive(clock, random, inlet, clog_watch, supply_watch, particles, lists, fluid, next_insertion, next_porosity,
            particle_steps, energy, step_watch, computing_time);
    if (model.scene.unclog.protocol == UnclogProtocol::rewind) archive(column);
    if (Archive::loading) lists.pairs.measure(particles);
  }
};

}  // namespace clogflow
