// Adding up seeds, and the ratios.
#include "postprocess/summary/totals.hpp"

#include <algorithm>
#include <cmath>

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

void add_bursts(Totals& totals, const SeedRecord& record, const Window& span) {
  const bool by_release = record.protocol == UnclogProtocol::release;
  for (const Burst& burst : record.bursts) {
    if (burst.start < span.start || burst.start >= span.end) continue;
    if (burst.kind == BurstKind::cut_off) {
      totals.cut_off_escaped += static_cast<double>(burst.size);
      continue;
    }
    if (by_release) {
      if (burst.kind == BurstKind::first) {
        totals.first_bursts += burst.size > 0 ? 1 : 0;
        totals.first_escaped += static_cast<double>(burst.size);
        continue;
      }
      ++totals.releases;
      totals.failed += burst.size == 0 ? 1 : 0;
      totals.while_off += static_cast<double>(burst.while_off);
    }
    totals.bursts += burst.size > 0 ? 1 : 0;
    totals.escaped += static_cast<double>(burst.size);
  }
}

bool is_permanently_clogged(const SeedRecord& record, const ClogScale& scale) {
  if (record.passages == 0 && record.releases == 0) {
    return record.window.end - record.window.start >= permanent_after * scale.tau;
  }
  return !record.lapses.empty() && record.lapses.back().end == LapseEnd::run &&
         record.lapses.back().duration >= permanent_after * scale.tau;
}

constexpr double Totals::*members[] = {
    &Totals::seeds,         &Totals::time,         &Totals::passages, &Totals::flowing_lapses,  &Totals::flowing_time,
    &Totals::clogged_time,  &Totals::bursts,       &Totals::escaped,  &Totals::cut_off_escaped, &Totals::first_bursts,
    &Totals::first_escaped, &Totals::releases,     &Totals::failed,   &Totals::while_off,       &Totals::arrests,
    &Totals::censored,      &Totals::log_exposure, &Totals::permanent};
static_assert(sizeof(members) / sizeof(*members) * sizeof(double) == sizeof(Totals));

}  // namespace

Totals totals_of(const SeedRecord& record, const ClogScale& scale, const Window& span) {
  Totals totals;
  totals.seeds = 1;
  totals.time = span.end - span.start;
  add_lapses(totals, record, scale, span);
  add_bursts(totals, record, span);
  totals.permanent = span.end >= record.window.end && is_permanently_clogged(record, scale) ? 1 : 0;
  return totals;
}

Totals operator+(const Totals& a, const Totals& b) {
  Totals sum;
  for (const auto member : members) sum.*member = a.*member + b.*member;
  return sum;
}

Totals sum_of(const std::vector<Totals>& parts) {
  Totals sum;
  for (const Totals& each : parts) sum = sum + each;
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
