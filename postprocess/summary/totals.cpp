// Adding up seeds, and the ratios.
#include "postprocess/summary/totals.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/scene/unclog_protocol.hpp"

namespace clogflow::postprocess {
namespace {

double time_within(const Lapse& lapse, const Window& span) {
  return std::max(0.0, std::min(lapse.start + lapse.duration, span.end) - std::max(lapse.start, span.start));
}

void add_lapses(Totals& totals, const SeedRecord& record, const ClogScale& scale, const Window& span) {
  for (const Lapse& lapse : record.lapses) {
    const bool is_arrest = lapse.duration >= scale.threshold;
    if (is_arrest) totals.clogged_time += time_within(lapse, span);
    if (lapse.start < span.start || lapse.start >= span.end) continue;
    ++totals.passages;
    if (is_arrest) {
      ++totals.arrests;
      totals.censored += lapse.end == LapseEnd::passage ? 0 : 1;
      totals.log_exposure += std::log(lapse.duration / scale.threshold);
    } else if (lapse.end == LapseEnd::passage) {
      ++totals.flowing_lapses;
      totals.flowing_time += lapse.duration;
    }
  }
}

bool is_permanently_clogged(const SeedRecord& record, const ClogScale& scale) {
  // A clog that is proved to be one ends the run long before 5 tau.
  if (record.protocol == UnclogProtocol::stop) return record.first_burst.clogged;
  const bool only_after_releases = record.lapses.empty() && record.releases > 0;
  return !only_after_releases && ends_clogged(record.lapses, record.window, scale.tau);
}

constexpr double Totals::*members[] = {
    &Totals::seeds,         &Totals::time,         &Totals::passages,  &Totals::flowing_lapses,  &Totals::flowing_time,
    &Totals::clogged_time,  &Totals::bursts,       &Totals::escaped,   &Totals::cut_off_escaped, &Totals::first_bursts,
    &Totals::first_escaped, &Totals::releases,     &Totals::failed,    &Totals::while_off,       &Totals::arrests,
    &Totals::censored,      &Totals::log_exposure, &Totals::permanent, &Totals::first_clogs,     &Totals::until_first};
static_assert(sizeof(members) / sizeof(*members) * sizeof(double) == sizeof(Totals));

}  // namespace

Totals totals_of(const SeedRecord& record, const ClogScale& scale, const Window& span) {
  Totals totals;
  totals.seeds = 1;
  totals.time = span.end - span.start;
  add_lapses(totals, record, scale, span);
  for (const Burst& burst : record.bursts)
    if (burst.start >= span.start && burst.start < span.end) totals = totals + totals_of(burst, record.protocol);
  if (span.start <= record.window.start) {
    totals.first_clogs = record.first_burst.clogged ? 1 : 0;
    totals.until_first = static_cast<double>(record.first_burst.size);
  }
  totals.permanent = span.end >= record.window.end && is_permanently_clogged(record, scale) ? 1 : 0;
  return totals;
}

Totals totals_of(const Burst& burst, UnclogProtocol protocol) {
  Totals totals;
  const auto size = static_cast<double>(burst.size), any = burst.size > 0 ? 1.0 : 0.0;
  if (burst.kind == BurstKind::cut_off) {
    totals.cut_off_escaped = size;
    return totals;
  }
  if (clears_clogs(protocol) && burst.kind == BurstKind::first) {
    totals.first_bursts = any;
    totals.first_escaped = size;
    return totals;
  }
  if (clears_clogs(protocol)) {
    totals.releases = 1;
    totals.failed = 1 - any;
    totals.while_off = static_cast<double>(burst.while_off);
  }
  totals.bursts = any;
  totals.escaped = size;
  return totals;
}

Totals& operator+=(Totals& sum, const Totals& more) {
  for (const auto member : members) sum.*member += more.*member;
  return sum;
}

Totals operator+(const Totals& a, const Totals& b) {
  Totals sum = a;
  return sum += b;
}

Totals sum_of(const std::vector<Totals>& parts) {
  Totals sum;
  for (const Totals& each : parts) sum += each;
  return sum;
}

double all_stops(const Totals& t) { return t.bursts + t.first_bursts; }

double all_escaped(const Totals& t) { return t.escaped + t.cut_off_escaped + t.first_escaped; }

Totals totals_of(const std::vector<SeedRecord>& records, const ClogScale& scale) {
  Totals sum;
  for (const SeedRecord& record : records) {
    // The last passage may fall on the end itself.
    const double end = std::nextafter(record.window.end, 2.0 * record.window.end);
    sum = sum + totals_of(record, scale, {record.window.start, end});
  }
  return sum;
}

}  // namespace clogflow::postprocess
