// Sums that add up over seeds; every published number is a ratio of them (quantities.hpp).
#pragma once

#include <vector>

#include "postprocess/events/seed_record.hpp"

namespace clogflow::postprocess {

/// What a seed contributes within a span of its time. Bursts, lapses and arrests belong to the span
/// in which they start, their time to the one in which it passes, so that two halves add up to the
/// whole.
struct Totals {
  double seeds = 0;
  double time = 0;             ///< [s]
  double passages = 0;         ///< with friction on
  double flowing_lapses = 0;   ///< whole lapses below T_min
  double flowing_time = 0;     ///< their sum [s]
  double clogged_time = 0;     ///< time in arrests, those cut by a release or the end included [s]
  double bursts = 0;           ///< counted ones with s >= 1
  double escaped = 0;          ///< sum of their s
  double cut_off_escaped = 0;  ///< sum of s over bursts that the end of the run cut off
  double first_bursts = 0;     ///< with releases: first ones of a run with s >= 1 that a clog ended
  double first_escaped = 0;    ///< sum of their s
  double releases = 0;         ///< whose burst is whole
  double failed = 0;           ///< of them, those followed by no passage
  double while_off = 0;        ///< passages while they held friction off
  double arrests = 0;          ///< lapses >= T_min, censored ones included
  double censored = 0;         ///< of them, those that no passage ended
  double log_exposure = 0;     ///< sum of ln(T/T_min) over the arrests
  double permanent = 0;        ///< seeds whose last arrest outlives the run (ends_clogged), or that a clog stopped
  double first_clogs = 0;      ///< seeds whose first burst a clog ended (first_burst_of)
  double until_first = 0;      ///< passages of the first bursts, those included that the end of the run cut
};

/// \param span part of the record's window [s]
Totals totals_of(const SeedRecord& record, const ClogScale& scale, const Window& span);

/// What a burst alone contributes.
Totals totals_of(const Burst& burst, UnclogProtocol protocol);

/// Of whole runs. \param records of one ensemble
Totals totals_of(const std::vector<SeedRecord>& records, const ClogScale& scale);

/// Bursts with s >= 1 that a clog ended, the first of a run included.
double all_stops(const Totals& totals);

/// Passages of these and of the bursts that the end of the run cut off.
double all_escaped(const Totals& totals);

Totals operator+(const Totals& a, const Totals& b);
Totals& operator+=(Totals& sum, const Totals& more);

Totals sum_of(const std::vector<Totals>& parts);

}  // namespace clogflow::postprocess
