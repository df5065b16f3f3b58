// clog run --until: which seeds of an ensemble count.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "ensemble/seed_run.hpp"
#include "postprocess/summary/stopping_rule.hpp"

namespace clogflow {

/// Takes the seeds of an ensemble in their order, as they get done, until the rule is met: that decides which of
/// them count. Ranks of one call, calls one after another and ranks of other numbers all decide the same.
class EnoughSeeds {
public:
  /// How it learns of a seed that is done: its file is found, or the rank that did it tells all others.
  enum class Learns { from_files, from_ranks };
  EnoughSeeds(postprocess::StoppingRule rule, Ensemble ensemble, Learns learns);

  /// Whether the seed counts, or may count as far as one knows yet.
  bool wanted(std::uint64_t seed);

  /// For ranks. The seed is done, by this rank or before; or another call has it, whose file is read when it comes.
  void is_done(std::uint64_t seed);
  void is_elsewhere(std::uint64_t seed) { elsewhere_.insert(index_of(seed)); }

  /// Appends what this rank knows of the next seeds to a sum over all ranks, as many numbers on each.
  void add_rows(std::vector<double>& sum);
  /// Takes it off the sum's front. \return whether it says anything new
  bool take_rows(std::span<const double>& sum);

  /// Gives run files that count their names, and removes the saved states of seeds that do not; of every
  /// `count`-th seed, from `rank` on. \throws Error if one cannot be written
  void settle(int rank, int count);

  /// What was decided, as a line; whether the rule was met.
  bool is_met() const { return enough_.has_value(); }
  std::string summary() const;

private:
  void read_on();
  void take(const postprocess::Totals& next);
  std::size_t next_rows() const;
  std::size_t index_of(std::uint64_t seed) const { return place_.at(seed); }
  std::optional<postprocess::Totals> totals_of_seed(std::uint64_t seed) const;

  postprocess::StoppingRule rule_;
  Ensemble ensemble_;
  postprocess::ClogScale scale_;
  Learns learns_;
  std::map<std::uint64_t, std::size_t> place_;       // of each seed in the list
  std::vector<postprocess::Totals> read_;            // of the first seeds
  std::optional<std::size_t> enough_;                // so many
  std::map<std::size_t, postprocess::Totals> mine_;  // of later seeds, known to this rank
  std::set<std::size_t> elsewhere_;
};

}  // namespace clogflow
