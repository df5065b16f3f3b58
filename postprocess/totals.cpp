// Adding up seeds, and the ratios.
#include "postprocess/totals.hpp"

#include <cmath>

namespace clog::postprocess {
namespace {

void add_lapses(Totals& totals, const SeedRecord& record, const ClogScale& scale,
                const Window& span) {
  for (const Lapse& lapse : record.lapses) {
    if (lapse.start < span.start || lapse.start >= span.end) continue;
    ++totals.passages;
    if (lapse.duration >= scale.threshold) {
      ++totals.arrests;
      totals.censored += lapse.end == LapseEnd::passage ? 0 : 1;
      totals.clogged_time += lapse.duration;
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
    &Totals::seeds,           &Totals::time,         &Totals::passages,     &Totals::flowing_lapses,
    &Totals::flowing_time,    &Totals::clogged_time, &Totals::bursts,       &Totals::escaped,
    &Totals::cut_off_escaped, &Totals::first_bursts, &Totals::first_escaped, &Totals::releases,
    &Totals::failed,          &Totals::while_off,    &Totals::arrests,       &Totals::censored,
    &Totals::log_exposure,    &Totals::permanent};
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

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      {"mean_burst", "1", "<s>: passages per burst, over bursts of one or more",
       [](const Totals& t) { return t.escaped / t.bursts; }},
      {"mean_burst_with_zeros", "1", "<s> when a release that nothing follows counts as s = 0",
       [](const Totals& t) { return t.escaped / (t.bursts + t.failed); }},
      {"mean_burst_censored", "1",
       "<s> by maximum likelihood, bursts that the end cut off included",
       [](const Totals& t) { return (t.escaped + t.cut_off_escaped) / t.bursts; }},
      {"mean_burst_memoryless", "1",
       "<s> by maximum likelihood, first bursts and those that the end cut off included",
       [](const Totals& t) { return all_escaped(t) / all_stops(t); }},
      {"mean_burst_by_threshold", "1", "passages per lapse of T_min and more, whatever ended it",
       [](const Totals& t) { return t.passages / t.arrests; }},
      {"share_failed", "1", "share of the releases that no passage follows",
       [](const Totals& t) { return t.failed / t.releases; }},
      {"passages_while_off", "1", "passages per release while friction was off (not part of s)",
       [](const Totals& t) { return t.while_off / t.releases; }},
      {"flow_rate", "1/s", "passages per time, clogs included",
       [](const Totals& t) { return t.passages / t.time; }},
      {"flow_rate_flowing", "1/s", "passages per time within bursts",
       [](const Totals& t) { return t.flowing_lapses / t.flowing_time; }},
      {"share_clogged", "1", "share of the time spent in lapses of T_min and more",
       [](const Totals& t) { return t.clogged_time / t.time; }},
      {"alpha_fixed", "1", "power-law exponent of T >= T_min, censored arrests included",
       [](const Totals& t) { return 1.0 + (t.arrests - t.censored) / t.log_exposure; }},
      {"share_censored", "1", "share of the arrests that a release or the end of the run cut",
       [](const Totals& t) { return t.censored / t.arrests; }},
      {"share_permanent", "1", "share of the seeds that end in a clog of 5 tau or more",
       [](const Totals& t) { return t.permanent / t.seeds; }},
  };
  return all;
}

Estimate estimate(const Quantity& quantity, const std::vector<Totals>& seeds,
                  const Resampling& resampling) {
  return bootstrap_over_seeds(
      seeds.size(),
      [&](const std::vector<std::size_t>& drawn) {
        Totals sum;
        for (const std::size_t k : drawn) sum = sum + seeds[k];
        return quantity.value(sum);
      },
      resampling);
}

Estimate estimate_change(const Quantity& quantity, const std::vector<std::array<Totals, 2>>& halves,
                         const Resampling& resampling) {
  return bootstrap_over_seeds(
      halves.size(),
      [&](const std::vector<std::size_t>& drawn) {
        Totals first, second;
        for (const std::size_t k : drawn) {
          first = first + halves[k][0];
          second = second + halves[k][1];
        }
        return quantity.value(second) - quantity.value(first);
      },
      resampling);
}

}  // namespace clog::postprocess
