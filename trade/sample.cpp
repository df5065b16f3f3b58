#include "trade/sample.hpp"

#include <algorithm>
#include <optional>

#include "coupling/base/require.hpp"
#include "coupling/files/run_file.hpp"

namespace clogflow::trade {

namespace fs = std::filesystem;
using postprocess::ClogScale;
using postprocess::Lapse;
using postprocess::SeedRecord;
using postprocess::Window;

namespace {

constexpr int pieces_per_run = 5;
constexpr double settled_after = 2;  // Stokes times without a passage: speeds fall exponentially, by e in some 0.2

/// The lapse during which a time lies, or nullptr: friction is off then, or nothing has passed yet.
const Lapse* lapse_around(const std::vector<Lapse>& lapses, double time) {
  const auto next = std::ranges::upper_bound(lapses, time, {}, &Lapse::start);
  if (next == lapses.begin()) return nullptr;
  const Lapse& last = *std::prev(next);
  return time < last.start + last.duration ? &last : nullptr;
}

void add(RowMean& mean, double value) {
  mean.sum += value;
  ++mean.rows;
}

void add_series(Piece& piece, const RunData& run, const SeedRecord& record, const ClogScale& scale,
                const Window& span) {
  const auto& s = run.series;
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    if (s.time[k] < span.start || s.time[k] >= span.end || s.count[k] == 0) continue;
    const Lapse* lapse = lapse_around(record.lapses, s.time[k]);
    if (!lapse) continue;
    if (lapse->duration < scale.threshold) {
      if (!s.porosity[k].empty()) add(piece.packing_while_flowing, 1 - s.porosity[k].back());
    } else if (s.time[k] - lapse->start >= settled_after * scale.tau) {
      add(piece.contacts_at_rest, 2 * static_cast<double>(s.contacts[k]) / static_cast<double>(s.count[k]));
    }
  }
}

void add_run(Sample& sample, const fs::path& file) {
  const RunData run = read_run_file(file);
  const Scene scene = parse_scene(run.scene_text, file.string());
  const double tau = scene.stokes_time();
  const ClogScale scale{tau, 0.5 * tau};
  const SeedRecord record = record_of(run, scene, scale);
  for (int k = 0; k < pieces_per_run; ++k) {
    const double length = (record.window.end - record.window.start) / pieces_per_run;
    const Window span{record.window.start + k * length,
                      k + 1 == pieces_per_run ? record.window.end : record.window.start + (k + 1) * length};
    Piece piece;
    piece.seed = run.seed, piece.number = k;
    piece.totals = totals_of(record, scale, span);
    if (k + 1 < pieces_per_run) piece.totals.seeds = 0;
    for (const postprocess::Burst& burst : record.bursts)
      if (burst.kind != postprocess::BurstKind::cut_off && burst.start >= span.start && burst.start < span.end)
        piece.sizes.push_back(static_cast<double>(burst.size));
    add_series(piece, run, record, scale, span);
    sample.pieces.push_back(std::move(piece));
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
  sample.processor_seconds += recorded(&RunRecord::processor_time);
  double step = 0;
  if (const double limit = run.record.contact_limit.value_or(0); limit > 0)
    step = recorded(&RunRecord::time_step) / limit;
  sample.largest_step = std::max(sample.largest_step, step);
  sample.mean_step += (step - sample.mean_step) / sample.runs;
}

}  // namespace

double Sample::clogs() const {
  double count = 0;
  for (const Piece& piece : pieces) count += static_cast<double>(piece.sizes.size());
  return count;
}

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

}  // namespace clogflow::trade
