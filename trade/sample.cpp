#include "trade/sample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "coupling/base/require.hpp"
#include "coupling/files/run_file.hpp"
#include "postprocess/events/run_groups.hpp"
#include "postprocess/laws/confidence.hpp"

namespace clogflow::trade {

namespace fs = std::filesystem;

namespace {

constexpr int pieces_per_run = 5;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

void add_series(Piece& piece, const RunData& run, const postprocess::Window& span, double diameter) {
  const auto& s = run.series;
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    if (s.time[k] < span.start || s.time[k] >= span.end || s.count[k] == 0) continue;
    ++piece.samples;
    piece.packing_fraction += s.packing_fraction[k];
    piece.coordination += 2 * static_cast<double>(s.contacts[k]) / static_cast<double>(s.count[k]);
    piece.largest_overlap += s.largest_overlap[k] / diameter;
  }
}

void add_run(Sample& sample, const fs::path& file) {
  const RunData run = read_run_file(file);
  const Scene scene = parse_scene(run.scene_text, file.string());
  const double tau = scene.stokes_time();
  const postprocess::ClogScale scale{tau, 0.5 * tau};
  const postprocess::SeedRecord record = record_of(run, scene, scale);
  for (int k = 0; k < pieces_per_run; ++k) {
    const double length = (record.window.end - record.window.start) / pieces_per_run;
    const postprocess::Window span{record.window.start + k * length, k + 1 == pieces_per_run
                                                                         ? record.window.end
                                                                         : record.window.start + (k + 1) * length};
    Piece piece{run.seed, k, totals_of(record, scale, span)};
    if (k + 1 < pieces_per_run) piece.totals.seeds = 0;
    add_series(piece, run, span, scene.particles.diameter);
    sample.pieces.push_back(piece);
  }
  ++sample.runs;
  const auto recorded = [&](std::optional<double> RunRecord::*entry) {
    const std::optional<double>& number = run.record.*entry;
    require(number.has_value(), "{}: its record has no {} (made by another program?)", file.string(),
            entry_name(entry));
    return *number;
  };
  sample.simulated += run.end_time + recorded(&RunRecord::fill_time);
  sample.particle_steps += recorded(&RunRecord::particle_steps);
  if (const double limit = run.record.contact_limit.value_or(0); limit > 0)
    sample.step_over_limit = std::max(sample.step_over_limit, recorded(&RunRecord::time_step) / limit);
  sample.wall_seconds += recorded(&RunRecord::wall_time);
}

}  // namespace

Sample read_sample(const fs::path& folder) {
  Sample sample;
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".h5") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) add_run(sample, file);
  return sample;
}

double Observable::value(const std::vector<const Piece*>& pieces) const {
  postprocess::Totals totals;
  double sum = 0, samples = 0;
  for (const Piece* piece : pieces) {
    totals = totals + piece->totals;
    samples += piece->samples;
    if (rows) sum += piece->*rows;
  }
  return quantity ? quantity->value(totals) : sum / samples;
}

const std::vector<Observable>& observables() {
  using postprocess::find_quantity;
  static const std::vector<Observable> all{
      {"flow_rate_flowing", "passages per second within bursts", false, find_quantity("flow_rate_flowing")},
      {"mean_burst", "<s>, passages per burst of one or more", false, find_quantity("mean_burst")},
      {"share_failed", "share of the releases that nothing follows", true, find_quantity("share_failed")},
      {"alpha", "exponent of T >= tau/2, censored arrests included", false, find_quantity("alpha_fixed")},
      {"share_censored", "share of the arrests that no passage ended", true, find_quantity("share_censored")},
      {"share_permanent", "share of the runs that end in a clog of 5 tau or more", true,
       find_quantity("share_permanent")},
      {"packing_fraction", "of the channel upstream", false, nullptr, &Piece::packing_fraction},
      {"coordination", "contacts with other particles, per particle", false, nullptr, &Piece::coordination},
  };
  return all;
}

Difference compare(const Observable& observable, const Sample& reference, const Sample& sample) {
  std::map<std::pair<std::uint64_t, int>, std::array<const Piece*, 2>> units;
  for (const Piece& piece : reference.pieces) units[{piece.seed, piece.number}][0] = &piece;
  for (const Piece& piece : sample.pieces) units[{piece.seed, piece.number}][1] = &piece;
  std::vector<std::array<const Piece*, 2>> pairs;
  for (const auto& [place, unit] : units) pairs.push_back(unit);
  const auto side = [&](const std::vector<std::size_t>& drawn, int which) {
    std::vector<const Piece*> pieces;
    for (const std::size_t k : drawn)
      if (pairs[k][which]) pieces.push_back(pairs[k][which]);
    return pieces;
  };
  const auto difference = [&](const std::vector<std::size_t>& drawn) {
    const double before = observable.value(side(drawn, 0)), after = observable.value(side(drawn, 1));
    return observable.is_share ? after - before : (after - before) / before;
  };
  if (reference.pieces.empty() || sample.pieces.empty()) return {undefined, undefined, undefined, undefined, undefined};
  // Shared among the observables (Bonferroni): a setting that changes nothing is called different once in
  // twenty times, whichever observable says so.
  const double level = 1 - 0.05 / static_cast<double>(observables().size());
  const postprocess::Estimate e = postprocess::bootstrap_over_seeds(pairs.size(), difference, {.level = level});
  std::vector<std::size_t> all(pairs.size());
  std::iota(all.begin(), all.end(), 0);
  return {observable.value(side(all, 0)), observable.value(side(all, 1)), e.low, e.high, e.value};
}

}  // namespace clogflow::trade
