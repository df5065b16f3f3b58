#include "ensemble/enough_seeds.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "ensemble/seed_files.hpp"
#include "ensemble/seed_lock.hpp"

namespace clogflow::cli {

EnoughSeeds::EnoughSeeds(postprocess::StoppingRule rule, Ensemble ensemble)
    : rule_(std::move(rule)),
      ensemble_(std::move(ensemble)),
      scale_(postprocess::clog_scale(ensemble_.scene, {}, "--until")) {}

bool EnoughSeeds::wanted(std::uint64_t seed) {
  read_on();
  const auto& seeds = ensemble_.scene.ensemble.seeds;
  return !enough_ ||
         std::find(seeds.begin(), seeds.end(), seed) - seeds.begin() < static_cast<std::ptrdiff_t>(*enough_);
}

void EnoughSeeds::read_on() {
  const auto& seeds = ensemble_.scene.ensemble.seeds;
  while (!enough_ && read_.size() < seeds.size()) {
    const auto next = totals_of_seed(seeds[read_.size()]);
    if (!next) return;
    read_.push_back(*next);
    if (rule_.met(read_)) enough_ = read_.size();
  }
}

/// Nothing for a seed that is not done, or whose file is bad: running it says why.
std::optional<postprocess::Totals> EnoughSeeds::totals_of_seed(std::uint64_t seed) const {
  // A file may get its final name between two looks.
  for (const auto& file : {run_file(ensemble_, seed), ahead_file(ensemble_, seed), run_file(ensemble_, seed)}) {
    if (!std::filesystem::exists(file)) continue;
    try {
      const RunData run = read_run_file(file);
      check_same_scene(run, ensemble_, seed, file);
      return postprocess::totals_of({postprocess::record_of(run, ensemble_.scene, scale_)}, scale_);
    } catch (const std::exception&) {
      continue;
    }
  }
  return {};
}

void EnoughSeeds::settle() {
  read_on();
  const auto& seeds = ensemble_.scene.ensemble.seeds;
  // A seed counts for certain as soon as those before it do not meet the rule, and once it is met no other does.
  const std::size_t certain = enough_.value_or(read_.size());
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const bool counts = i < certain;
    if (counts ? !std::filesystem::exists(ahead_file(ensemble_, seeds[i])) : !enough_) continue;
    // Where another rank has the lock, it is doing the same.
    const auto lock = SeedLock::take(run_file(ensemble_, seeds[i]), "");
    if (!lock) continue;
    counts ? accept_ahead(ensemble_, seeds[i]) : remove_states(ensemble_, seeds[i]);
  }
}

std::string EnoughSeeds::summary() const {
  const std::size_t all = ensemble_.scene.ensemble.seeds.size();
  const std::string value = read_.empty() ? "" : fmt::format(", {} = {:.4g}", rule_.statistic(), rule_.value(read_));
  if (enough_) return fmt::format("{} is met by the first {} of {} seeds{}", rule_.text(), *enough_, all, value);
  return fmt::format("{} is not met by {} of {} seeds{}", rule_.text(), read_.size(), all, value);
}

}  // namespace clogflow::cli
