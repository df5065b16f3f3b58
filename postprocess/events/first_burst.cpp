#include "postprocess/events/first_burst.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/scene/unclog_protocol.hpp"

namespace clogflow::postprocess {
namespace {

/// The release that ended the first clog in the window, as a row of the table; none: its length.
std::size_t first_release(const RunData& run, const Window& window) {
  const auto& off = run.releases.off;
  return static_cast<std::size_t>(std::ranges::lower_bound(off, window.start) - off.begin());
}

/// The passages of the first burst [s].
std::vector<double> passages_until(const RunData& run, const Window& window, double end) {
  std::vector<double> times;
  for (std::size_t i = 0; i < run.passages.time.size(); ++i) {
    const double time = run.passages.time[i];
    if (!run.passages.friction_off[i] && time >= window.start && time <= end) times.push_back(time);
  }
  return times;
}

/// Solids near the neck in the samples of [from, to], in order of time [-].
std::vector<double> packing_near_neck(const RunData& run, const Scene& scene, const Window& span) {
  std::vector<double> packing;
  for (std::size_t i = 0; i < run.series.porosity.size(); ++i) {
    const auto& strips = run.series.porosity[i];
    // A neck that is a strip of its own comes after them.
    const std::size_t upstream = std::min(strips.size(), static_cast<std::size_t>(scene.porosity.strips));
    if (upstream > 0 && run.series.time[i] >= span.start && run.series.time[i] <= span.end)
      packing.push_back(1 - strips[upstream - 1]);
  }
  return packing;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());  // NaN of none
}

}  // namespace

FirstBurst first_burst_of(const RunData& run, const Scene& scene, const Window& window, double tau) {
  FirstBurst burst;
  double end = window.end;
  if (clears_clogs(scene.unclog.protocol)) {
    const std::size_t row = first_release(run, window);
    burst.clogged = row < run.releases.off.size();
    if (burst.clogged) {
      end = run.releases.off[row];
      burst.clog_position = run.releases.position[row];
    }
  } else if (scene.unclog.protocol == UnclogProtocol::stop) {
    burst.clogged = run.record.clogged_at.has_value();
    burst.clog_position = run.record.clog_position;
  } else {
    burst.clogged = ends_clogged(lapses_of(run, window), window, tau);
  }
  const auto passages = passages_until(run, window, end);
  burst.size = passages.size();
  if (!passages.empty())
    burst.packing_flowing = mean_of(packing_near_neck(run, scene, {window.start, passages.back()}));
  const auto all = packing_near_neck(run, scene, {window.start, end});
  if (!all.empty()) burst.packing_at_end = all.back();
  return burst;
}

}  // namespace clogflow::postprocess
