#include "ensemble/enough_seeds.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "coupling/base/require.hpp"
#include "ensemble/seed_files.hpp"
#include "ensemble/seed_lock.hpp"

namespace clogflow {

namespace {

using postprocess::Totals;

/// Seeds of one sum over ranks: more are rarely done between two.
constexpr std::size_t rows_per_sum = 64;

/// A row is 1 and the totals, or zeros: a seed is told by one rank, so the sum is exact.
constexpr std::size_t numbers = sizeof(Totals) / sizeof(double);
using Numbers = std::array<double, numbers>;
static_assert(sizeof(Totals) == sizeof(Numbers));

std::set<std::string> names_in(const std::filesystem::path& directory) {
  std::set<std::string> names;
  std::error_code none_yet;
  for (const auto& entry : std::filesystem::directory_iterator(directory, none_yet))
    names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

EnoughSeeds::EnoughSeeds(postprocess::StoppingRule rule, Ensemble ensemble, Learns learns)
    : rule_(std::move(rule)),
      ensemble_(std::move(ensemble)),
      scale_(postprocess::clog_scale(ensemble_.scene, {}, "--until")),
      learns_(learns) {
  const auto& seeds = ensemble_.scene.ensemble.seeds;
  for (std::size_t i = 0; i < seeds.size(); ++i) place_.emplace(seeds[i], i);
}

bool EnoughSeeds::wanted(std::uint64_t seed) {
  if (learns_ == Learns::from_files) read_on();
  return !enough_ || index_of(seed) < *enough_;
}

void EnoughSeeds::take(const Totals& next) {
  read_.push_back(next);
  if (rule_.met(read_)) enough_ = read_.size();
}

void EnoughSeeds::read_on() {
  const auto& seeds = ensemble_.scene.ensemble.seeds;
  while (!enough_ && read_.size() < seeds.size()) {
    const auto next = totals_of_seed(seeds[read_.size()]);
    if (!next) return;
    take(*next);
  }
}

void EnoughSeeds::is_done(std::uint64_t seed) {
  if (const auto totals = totals_of_seed(seed)) mine_[index_of(seed)] = *totals;
}

std::size_t EnoughSeeds::next_rows() const {
  return enough_ ? 0 : std::min(rows_per_sum, ensemble_.scene.ensemble.seeds.size() - read_.size());
}

void EnoughSeeds::add_rows(std::vector<double>& sum) {
  for (std::size_t i = read_.size(); i < read_.size() + next_rows(); ++i) {
    if (elsewhere_.contains(i) && !mine_.contains(i)) is_done(ensemble_.scene.ensemble.seeds[i]);
    const auto row = mine_.find(i);
    sum.push_back(row == mine_.end() ? 0 : 1);
    const Numbers known = row == mine_.end() ? Numbers{} : std::bit_cast<Numbers>(row->second);
    sum.insert(sum.end(), known.begin(), known.end());
  }
}

bool EnoughSeeds::take_rows(std::span<const double>& sum) {
  const std::size_t before = read_.size(), rows = next_rows();
  const auto own = sum.first(rows * (1 + numbers));
  sum = sum.subspan(own.size());
  for (std::size_t k = 0; k < rows && !enough_; ++k) {
    const auto row = own.subspan(k * (1 + numbers), 1 + numbers);
    if (row[0] == 0) break;
    Numbers known;
    std::copy_n(row.begin() + 1, numbers, known.begin());
    take(std::bit_cast<Totals>(known));
  }
  mine_.erase(mine_.begin(), mine_.lower_bound(read_.size()));
  return read_.size() > before;
}

/// Nothing for a seed that is not done, or whose file is bad: running it says why.
std::optional<Totals> EnoughSeeds::totals_of_seed(std::uint64_t seed) const {
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

void EnoughSeeds::settle(int rank, int count) {
  if (learns_ == Learns::from_files) read_on();
  const auto& seeds = ensemble_.scene.ensemble.seeds;
  const std::set<std::string> there = names_in(ensemble_.directory);
  // A seed counts for certain as soon as those before it do not meet the rule, and once it is met no other does.
  const std::size_t certain = enough_.value_or(read_.size());
  for (auto i = static_cast<std::size_t>(rank); i < seeds.size(); i += static_cast<std::size_t>(count)) {
    const bool counts = i < certain;
    if (!counts && !enough_) continue;
    const std::string name = counts ? ahead_file(ensemble_, seeds[i]).filename().string()
                                    : run_file(ensemble_, seeds[i]).stem().string() + ".state";
    if (const auto found = there.lower_bound(name); found == there.end() || !found->starts_with(name)) continue;
    // Where another process has the lock, it is doing the same.
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

}  // namespace clogflow
