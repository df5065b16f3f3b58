// clog stats: the numbers of an ensemble.
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "coupling/scene/unclog_protocol.hpp"
#include "ensemble/ranks.hpp"
#include "postprocess/events/run_groups.hpp"
#include "postprocess/output/statistics_files.hpp"
#include "postprocess/output/statistics_json.hpp"

namespace clogflow::cli {
namespace {

double threshold_seconds(const std::string& text) {
  constexpr const char* meaning = "a positive time such as '3.3 ms'";
  const double seconds = parse_option("--threshold", text, dimension::time, meaning);
  require(seconds > 0, "--threshold {} (must be {})", text, meaning);
  return seconds;
}

/// The value, or the bound on it, or what it lacks.
std::string known(const postprocess::Estimate& q) {
  if (!std::isfinite(q.value)) {
    if (std::isfinite(q.high)) return fmt::format("below {:.4g} ({})", q.high, q.note);
    if (std::isfinite(q.low)) return fmt::format("above {:.4g} ({})", q.low, q.note);
    return fmt::format("unknown ({})", q.note);
  }
  if (!std::isfinite(q.low)) return fmt::format("{:.4g}", q.value);
  return fmt::format("{:.4g} [{:.4g}, {:.4g}]", q.value, q.low, q.high);
}

std::string with_interval(const postprocess::GroupStatistics& group, const char* key) {
  const auto& q = group.of(key);
  const bool drifts = q.halves && q.halves->drifts.value_or(false);
  return known(q.whole) + (drifts ? " (drifts: first and second half differ)" : "");
}

/// What is known to be wrong with the laws behind the numbers.
void print_verdicts(const postprocess::GroupStatistics& group) {
  const auto* alpha = std::get_if<postprocess::ArrestFit>(&group.power_laws.fixed_censored);
  if (alpha && alpha->verdict.ruled_out) print_result("  alpha: {}\n", alpha->verdict.words);
  const auto& spread = group.bursts.spread;
  if (spread && spread->verdict.ruled_out) print_result("  s: geometric law {}\n", spread->verdict.words);
  if (group.burst_order && group.burst_order->depends) print_result("  s: {}\n", group.burst_order->words);
  if (const std::string words = cut_off_words(group); !words.empty()) print_result("  s: {}\n", words);
}

/// Passages until the first clog, in one line: nothing else is known of runs that end there.
void print_first_burst(const postprocess::GroupStatistics& group) {
  const auto& first = group.first_burst;
  const auto& packing = first.packing.flowing.value;
  print_result(
      "{}: <s> = {} passages until the first clog{}, {} seeds, {} cut by the end; geometric law {}", group.label,
      known(first.mean.mean),
      first.mean.is_restricted && first.clogged > 0 ? fmt::format(" (restricted to {})", first.mean.up_to) : "",
      first.seeds, first.seeds - first.clogged, first.verdict.words);
  print_result("; packing near the neck {}\n", std::isfinite(packing) ? fmt::format("{:.3g}", packing) : "unknown");
  if (const auto& tail = first.tail)
    print_result("  memoryless from {} passages on: hazard {} per passage, {} clogs (p = {:.2g})\n", tail->from,
                 known(tail->hazard), tail->events, tail->test.p_value);
  const auto& places = first.places;
  if (places.upstream > 0)
    print_result("  {} of {} clogs stood more than a neck width upstream of the neck: not the neck's\n",
                 places.upstream, places.known);
}

/// Each neck of several alone: the lines above are of all together.
void print_necks(const postprocess::RunGroup& group, const postprocess::GroupStatistics& numbers) {
  const bool stops = group.scene.unclog.protocol == UnclogProtocol::stop;
  for (std::size_t k = 0; k < numbers.necks.size(); ++k) {
    const postprocess::GroupStatistics& neck = numbers.necks[k];
    std::size_t passages = 0;
    for (const postprocess::SeedRecord& record : group.necks[k]) passages += record.passages;
    print_result("  neck {}: {} passages, <s> = {}, by T_min {}, {} arrests\n", k, passages,
                 stops ? known(neck.first_burst.mean.mean) : known(neck.of("mean_burst").whole),
                 known(neck.of("mean_burst_by_threshold").whole),
                 neck.lapses.arrests.passage + neck.lapses.arrests.release + neck.lapses.arrests.end_of_run);
  }
}

void print_summary(const postprocess::Statistics& statistics) {
  for (std::size_t i = 0; i < statistics.groups.size(); ++i) {
    const auto& group = statistics.numbers[i];
    const UnclogProtocol protocol = statistics.groups[i].scene.unclog.protocol;
    if (protocol == UnclogProtocol::stop) {
      print_first_burst(group);
      print_necks(statistics.groups[i], group);
      continue;
    }
    const bool by_release = clears_clogs(protocol);
    print_result("{}: {} seeds, {} bursts, <s> = {}, {} = {}, {} passages/s{}\n", group.label,
                 statistics.groups[i].records.size(), group.bursts.counted, with_interval(group, "mean_burst"),
                 by_release ? "releases without a passage" : "alpha(T_min)",
                 with_interval(group, by_release ? "share_failed" : "alpha_fixed"),
                 with_interval(group, by_release ? "flow_rate_flowing" : "flow_rate"),
                 by_release ? " while it flows" : "");
    print_verdicts(group);
    print_necks(statistics.groups[i], group);
  }
}

void print_law(const std::string& label, const char* symbol, const postprocess::SweepLaw& law) {
  print_result("{}{}", label, label.empty() ? "" : ": ");
  if (!law.line) {
    print_result("no law for {}: {}\n", symbol, law.refused);
    return;
  }
  const auto& b = law.line->slope;
  print_result("{} = A exp(b {}), b = {:.4g} [{:.4g}, {:.4g}] from {} points, p = {:.2g}\n", symbol, law.x, b.value,
               b.low, b.high, law.points, law.line->p_value);
}

/// The laws of a sweep, or why there is none; nothing for a single ensemble.
void print_trend(const postprocess::Statistics& statistics) {
  for (const std::string& name : statistics.without_runs) print_result("{}: no runs yet\n", name);
  if (statistics.groups.size() < 2) return;
  for (const auto& series : statistics.trend.series) {
    print_law(series.label, "<s>", series.mean_burst);
    print_law(series.label, "alpha", series.alpha);
  }
}

}  // namespace

void add_stats(CLI::App& app) {
  auto* verb = app.add_subcommand("stats", "bursts, arrests and fits from run files");
  auto job = std::make_shared<postprocess::StatisticsJob>();
  auto threshold = std::make_shared<std::string>();
  verb->add_option("dirs", job->folders, "folders with run_*.h5, a sweep's folder of such folders, or packs of runs")
      ->required();
  verb->add_option("--out", job->out, "folder for stats.json and the tables")->required();
  verb->add_option("--threshold", *threshold, "shortest lapse that is a clog, such as '3.3 ms' (default tau/2)");
  verb->add_option("--p-value", job->request.p_value_replicates, "bootstrap replicates of the goodness of fit, 0: none")
      ->capture_default_str();
  verb->add_option("--seed", job->request.resampling.seed, "of all bootstraps")->capture_default_str();
  verb->callback([job, threshold] {
    // Seconds of work, once: ranks would write the same files at the same time.
    const Ranks ranks;
    if (!ranks.is_first()) return;
    if (!threshold->empty()) job->threshold = threshold_seconds(*threshold);
    const auto statistics = postprocess::write_statistics(*job);
    if (const auto states = postprocess::unfinished_seeds(job->folders); !states.empty())
      print_note(
          fmt::format("seeds that have not ended are left out: {}, such as {}; the same `clog run` goes on with them",
                      states.size(), states.front().string()));
    if (json_wanted()) return print_json(postprocess::as_json(statistics));
    print_summary(statistics);
    print_trend(statistics);
  });
}

}  // namespace clogflow::cli
