// clog run --until: which seeds of an ensemble count.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ensemble/seed_run.hpp"
#include "postprocess/summary/stopping_rule.hpp"

namespace clogflow::cli {

/// Reads the seeds of an ensemble in their order, as they get done, until the rule is met: that decides which of
/// them count. Ranks of one call, calls one after another and ranks of other numbers all decide the same.
class EnoughSeeds {
public:
  EnoughSeeds(postprocess::StoppingRule rule, Ensemble ensemble);

  /// Whether the seed counts, or may count as far as one knows yet.
  bool wanted(std::uint64_t seed);

  /// Gives run files that count their names, and removes the saved states of seeds that do not.
  /// \throws Error if one cannot be written
  void settle();

  /// What was decided, as a line; whether the rule was met.
  bool is_met() const { return enough_.has_value(); }
  std::string summary() const;

private:
  void read_on();
  std::optional<postprocess::Totals> totals_of_seed(std::uint64_t seed) const;

  postprocess::StoppingRule rule_;
  Ensemble ensemble_;
  postprocess::ClogScale scale_;
  std::vector<postprocess::Totals> read_;  // of the first seeds
  std::optional<std::size_t> enough_;      // so many
};

}  // namespace clogflow::cli
