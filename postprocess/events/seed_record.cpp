// Cuts a run down to what the statistics need.
#include "postprocess/events/seed_record.hpp"

#include <limits>

#include "coupling/base/quantile.hpp"
#include "coupling/base/require.hpp"
#include "coupling/scene/unclog_protocol.hpp"

namespace clogflow::postprocess {
namespace {

/// The count of a full channel wavers by a few per cent while bursts leave and are refilled.
constexpr double full_share = 0.95;

SteadyState steady_state(const RunData& run, const Window& window) {
  const double from = 0.5 * (window.start + window.end);
  const auto& series = run.series;
  SteadyState steady;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (series.time[i] < from || series.time[i] > window.end) continue;
    ++steady.samples;
    steady.particles += static_cast<double>(series.count[i]);
    steady.packing_fraction += series.packing_fraction[i];
    if (series.porosity.empty()) continue;
    steady.porosity.resize(series.porosity[i].size());
    for (std::size_t k = 0; k < steady.porosity.size(); ++k) steady.porosity[k] += series.porosity[i][k];
  }
  const double share =
      steady.samples > 0 ? 1.0 / static_cast<double>(steady.samples) : std::numeric_limits<double>::quiet_NaN();
  steady.particles *= share;
  steady.packing_fraction *= share;
  for (double& eps : steady.porosity) eps *= share;
  return steady;
}

PassedSizes passed_sizes(const RunData& run, const Window& window) {
  PassedSizes sizes;
  for (std::size_t i = 0; i < run.passages.radius.size(); ++i) {
    const auto species = run.passages.species[i];
    if (run.passages.time[i] < window.start || species < 0 || species >= static_cast<std::int64_t>(most_species))
      continue;
    const auto k = static_cast<std::size_t>(species);
    if (sizes.of_species.size() <= k) sizes.of_species.resize(k + 1, 0);
    ++sizes.of_species[k];
    sizes.diameters += 2 * run.passages.radius[i];
  }
  return sizes;
}

bool fills_behind_a_gate(const Scene& scene) { return scene.inlet.enabled && scene.inlet.start != InletStart::empty; }

std::vector<Burst> bursts_of(const RunData& run, const Scene& scene, const ClogScale& scale, const SeedRecord& record) {
  if (clears_clogs(record.protocol)) return bursts_after_releases(run, record.window, scene.unclog.after);
  if (record.protocol == UnclogProtocol::stop)
    return {burst_until_stop(run, record.window, record.first_burst.clogged ? BurstKind::first : BurstKind::cut_off)};
  return bursts_between_clogs(run, record.window, scale.threshold);
}

}  // namespace

ClogScale clog_scale(const Scene& scene, std::optional<double> threshold, const std::string& where) {
  const double tau = scene.stokes_time();
  require(tau > 0 || threshold,
          "{}: its scene has no flow, hence no Stokes time d/v to define a clog: give --threshold", where);
  const double t_min = threshold.value_or(0.5 * tau);
  return {tau > 0 ? tau : 2.0 * t_min, t_min};
}

double end_of_filling(const RunData& run, const Scene& scene) {
  const auto& time = run.series.time;
  const auto& count = run.series.count;
  if (!scene.inlet.enabled || fills_behind_a_gate(scene) || time.empty()) return 0;
  std::vector<std::int64_t> late(count.begin() + static_cast<std::ptrdiff_t>(count.size() / 2), count.end());
  const double full = full_share * static_cast<double>(quantile(late, 0.5));
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (static_cast<double>(count[i]) >= full) return time[i];
  }
  return 0;
}

RunData through_neck(const RunData& run, std::int64_t neck) {
  RunData part = run;
  part.passages = {};
  for (std::size_t i = 0; i < run.passages.neck.size(); ++i) {
    if (run.passages.neck[i] != neck) continue;
    part.passages.time.push_back(run.passages.time[i]);
    part.passages.id.push_back(run.passages.id[i]);
    part.passages.y.push_back(run.passages.y[i]);
    part.passages.z.push_back(run.passages.z[i]);
    part.passages.friction_off.push_back(run.passages.friction_off[i]);
  }
  return part;
}

SeedRecord record_of(const RunData& run, const Scene& scene, const ClogScale& scale) {
  SeedRecord record;
  record.seed = run.seed;
  record.protocol = scene.unclog.protocol;
  record.window = {end_of_filling(run, scene), run.end_time};
  for (std::size_t i = 0; i < run.passages.time.size(); ++i) {
    if (run.passages.time[i] < record.window.start) continue;
    ++record.passages;
    record.while_off += run.passages.friction_off[i];
  }
  record.sizes = passed_sizes(run, record.window);
  record.lapses = lapses_of(run, record.window);
  record.releases = run.releases.off.size();
  record.first_burst = first_burst_of(run, scene, record.window, scale.tau);
  record.start_flowed = run.record.start_flowed;
  record.bursts = bursts_of(run, scene, scale, record);
  record.steady = steady_state(run, record.window);
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  record.filling_time = fills_behind_a_gate(scene) ? run.record.fill_time.value_or(unknown) : record.window.start;
  record.wall_time = run.record.wall_time.value_or(unknown);
  return record;
}

}  // namespace clogflow::postprocess
