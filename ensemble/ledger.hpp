// ensemble.csv: who worked on which seed, from when to when. One line for every end of a seed.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "ensemble/launch.hpp"

namespace clogflow {

struct LedgerEntry {
  std::string point;  ///< of the sweep; empty: none
  std::uint64_t seed = 0;
  double began = 0, ended = 0;  ///< since 1970 [s]
  std::string outcome;          ///< done, failed, stopped, left
};

/// Begins when it is made. Durations are those of a clock that never goes back, as that of the day may.
class Stopwatch {
public:
  Stopwatch();
  double began() const { return began_; }  ///< since 1970 [s]
  double seconds() const;                  ///< since then [s]

private:
  double began_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Many processes append to one file, each line whole or not at all.
class Ledger {
public:
  Ledger(std::filesystem::path file, Launch launch) : file_(std::move(file)), launch_(std::move(launch)) {}

  /// \throws Error if the line cannot be written; the file is as it was
  void append(const LedgerEntry& entry) const;

  /// What all ranks of this call did together.
  struct Sum {
    double busy = 0;         ///< at work on seeds [s]
    std::size_t failed = 0;  ///< seeds whose last end that was
  };
  /// \param asked_for  name_of the seeds of this call: other calls may have had its name
  Sum sum(const std::set<std::string>& asked_for) const;

  static std::string name_of(const std::string& point, std::uint64_t seed);

private:
  std::filesystem::path file_;
  Launch launch_;
};

}  // namespace clogflow
