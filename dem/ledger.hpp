// ensemble.csv: who worked on which seed, from when to when. One line for every end of a seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "dem/launch.hpp"

namespace clog {

struct LedgerEntry {
  std::string point;  ///< of the sweep; empty: none
  std::uint64_t seed = 0;
  double began = 0, ended = 0;  ///< since 1970 [s]
  std::string outcome;          ///< done, failed, stopped, left
};

/// Seconds since 1970 [s]
double seconds_now();

/// Many processes append to one file, each line whole or not at all.
class Ledger {
public:
  Ledger(std::filesystem::path file, Launch launch) : file_(std::move(file)), launch_(std::move(launch)) {}

  /// \throws Error if the line cannot be written; the file is as it was
  void append(const LedgerEntry& entry) const;

  /// What all ranks of this call did together.
  struct Sum {
    double busy = 0;         ///< at work on seeds [s]
    std::size_t failed = 0;  ///< seeds
  };
  Sum sum() const;

private:
  std::filesystem::path file_;
  Launch launch_;
};

}  // namespace clog
