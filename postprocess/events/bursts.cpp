// Counting passages between clogs and between releases.
#include "postprocess/events/bursts.hpp"

#include <algorithm>
#include <cmath>

namespace clogflow::postprocess {
namespace {

/// Passages with the given friction state in [from, to).
std::vector<double> passages_in(const RunData& run, const Window& span, std::uint8_t friction_off) {
  std::vector<double> times;
  for (std::size_t i = 0; i < run.passages.time.size(); ++i) {
    const double time = run.passages.time[i];
    if (run.passages.friction_off[i] == friction_off && time >= span.start && time < span.end) {
      times.push_back(time);
    }
  }
  return times;
}

Burst burst_of(const std::vector<double>& times, double start) {
  Burst burst;
  burst.start = start;
  burst.size = times.size();
  if (!times.empty()) burst.duration = times.back() - times.front();
  return burst;
}

}  // namespace

const char* name(BurstKind kind) {
  switch (kind) {
    case BurstKind::whole:
      return "whole";
    case BurstKind::first:
      return "first";
    case BurstKind::cut_off:
      return "cut off";
  }
  return "";
}

std::vector<Burst> bursts_between_clogs(const RunData& run, const Window& window, double threshold) {
  std::vector<Burst> bursts;
  bool clogged = true;
  for (const Lapse& lapse : lapses_of(run, window)) {
    if (clogged) bursts.push_back({lapse.start, 0, 0, 0, BurstKind::cut_off});
    Burst& burst = bursts.back();
    ++burst.size;
    burst.duration = lapse.start - burst.start;
    clogged = lapse.duration >= threshold || lapse.end == LapseEnd::release;
    if (clogged) burst.kind = bursts.size() == 1 ? BurstKind::first : BurstKind::whole;
  }
  return bursts;
}

std::vector<Burst> bursts_after_releases(const RunData& run, const Window& window, double rest) {
  const auto& [off, on, speed, position] = run.releases;
  std::vector<Burst> bursts;
  const double first_release = off.empty() ? window.end : off.front();
  bursts.push_back(burst_of(passages_in(run, {window.start, first_release}, 0), window.start));
  bursts.back().kind = off.empty() ? BurstKind::cut_off : BurstKind::first;
  for (std::size_t k = 0; k < off.size(); ++k) {
    if (off[k] < window.start || on[k] > window.end) continue;
    const bool is_last = k + 1 == off.size();
    const Window span{on[k], is_last ? window.end : off[k + 1]};
    const auto times = passages_in(run, span, 0);
    Burst burst = burst_of(times, on[k]);
    burst.while_off = passages_in(run, {off[k], on[k]}, 1).size();
    const double last_event = times.empty() ? on[k] : times.back();
    if (is_last && window.end - last_event < rest) burst.kind = BurstKind::cut_off;
    bursts.push_back(burst);
  }
  return bursts;
}

Burst burst_until_stop(const RunData& run, const Window& window, BurstKind kind) {
  // The last passage may fall on the end itself.
  Burst burst = burst_of(passages_in(run, {window.start, std::nextafter(window.end, 2 * window.end)}, 0), window.start);
  burst.kind = kind;
  return burst;
}

}  // namespace clogflow::postprocess
