// What all ranks of a call know of each other, renewed while they compute.
#pragma once

#include <vector>

#include "ensemble/enough_seeds.hpp"
#include "ensemble/ledger.hpp"
#include "ensemble/ranks.hpp"
#include "ensemble/standing.hpp"

namespace clogflow {

/// One reduction after the other, each over all ranks: how the seeds stand, and what the rules of --until need of those
/// that are done. All ranks get the same sums in the same order, so they decide the same and end after the same one.
/// A rank takes part whenever it looks; none waits for another.
class Pulse {
public:
  Pulse(Ranks& ranks, std::vector<EnoughSeeds*> decisions) : ranks_(ranks), decisions_(std::move(decisions)) {}

  /// Takes part, if it is time. \param mine  how this rank stands
  void beat(const Standing& mine);

  /// Until nothing new comes of it. All ranks together.
  void settle(const Standing& mine);

  /// Until all ranks have finished. \param meanwhile  done at least 50 times a second
  void finish(Standing mine, const std::function<void()>& meanwhile);

  const Standing& all() const { return all_; }

private:
  bool take(const std::vector<double>& sum);
  void begin(const Standing& mine);
  bool is_due() const;

  Ranks& ranks_;
  std::vector<EnoughSeeds*> decisions_;
  Standing all_;
  bool under_way_ = false, is_last_ = false;
  Stopwatch watch_;
  double last_ = -1;  // on the watch [s]
};

}  // namespace clogflow
