#include "dem/plan/disk_use.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "coupling/scene/unclog_protocol.hpp"
#include "dem/plan/plan.hpp"

namespace clogflow {
namespace {

constexpr double number = 8;  // bytes

/// Tables below this are stored as they are.
constexpr double compressed_from = 1 << 16;

/// What compression left of tables in files of the campaign: sums of motion look random, counts and ids do not.
constexpr double series_left = 0.6, passages_left = 0.7, motion_left = 0.88, ids_left = 0.2;

/// Place, velocity, spin, force and torque; id and radius [numbers].
constexpr double motion = 15, ids = 2;

constexpr double series_columns = 13, passage_row = 4 * number + 1;

/// Of the state that a run could be lengthened from, packed; a resting pack of 300 to 500 was seen with 110 to 160.
constexpr double state_per_particle = 130;

/// Scene and provenance, groups and names, and of the index beside it the lines of a snapshot.
constexpr double fixed = 30e3, index_of_a_snapshot = 1500;

double table(double rows, double row, double left) {
  const double bytes = rows * row;
  return bytes * (rows * number < compressed_from ? 1 : left);
}

/// Snapshots of a burst of so many intervals: dem/protocol/burst_clock.hpp.
double snapshots_of_burst(double intervals) {
  constexpr double at_first = 50, at_each_spacing = 25;
  return intervals <= at_first ? std::floor(intervals) + 1
                               : at_first + at_each_spacing * std::log2(intervals / at_first);
}

/// Particles that solids of `strain` neck widths times its cross-section are.
double particles_of(const Scene& s, double strain) {
  return strain * s.geometry.neck_width * neck_section(s.geometry) / ParticleSizes(s.particles).mean_volume();
}

/// Passages and snapshots of bursts in `time` [s].
void count_bursts(const Scene& s, const ExpectedBurst& burst, double time, DiskUse& use) {
  const double spacing = s.output.burst_snapshots;
  if (!s.geometry.present || !s.inlet.enabled || s.flow_speed() <= 0) return;
  if (!burst.unknown.empty()) {
    // As if it flowed all the time, and as if every snapshot were one of the first of its burst.
    use.is_at_most = true;
    use.passage_count = particles_of(s, 1) * time / frictionless_time(s, 1, packing_of_start);
    if (spacing > 0) use.snapshot_count += time / spacing;
    return;
  }
  const bool again = restarts(s.unclog.protocol);
  const double length = burst.flow + (again ? burst.start : 0);
  const double bursts = again ? std::max(1.0, time / burst.simulated()) : 1;
  use.passage_count = bursts * (burst.mean + particles_of(s, again ? s.unclog.strain : s.inlet.strain));
  if (spacing > 0) use.snapshot_count += bursts * snapshots_of_burst((length + s.stokes_time()) / spacing);
}

}  // namespace

DiskUse disk_use(const Scene& s, double particles, const ExpectedBurst& burst) {
  DiskUse use;
  const bool stops = s.unclog.protocol == UnclogProtocol::stop && burst.unknown.empty();
  const double time = stops ? std::min(s.time.end, burst.flow + burst.proof) : s.time.end;
  use.snapshot_count = 2 + (s.output.snapshot_interval > 0 ? std::floor(time / s.output.snapshot_interval) : 0);
  count_bursts(s, burst, time, use);
  if (s.output.series_interval > 0) use.series_rows = 1 + std::floor(time / s.output.series_interval);
  const double columns = series_columns + s.porosity.strips + (s.flow.oscillation.on() || s.flow.balances() ? 2 : 0);
  use.snapshots = table(particles * use.snapshot_count, motion * number, motion_left) +
                  table(particles * use.snapshot_count, ids * number, ids_left) +
                  index_of_a_snapshot * use.snapshot_count;
  use.series = table(use.series_rows, columns * number, series_left);
  use.passages = table(use.passage_count, passage_row, passages_left);
  use.end_state = state_per_particle * particles;
  use.rest = fixed;
  return use;
}

}  // namespace clogflow
