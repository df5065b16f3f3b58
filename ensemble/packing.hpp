// From a folder of run files to one file.
#pragma once

#include <cstddef>
#include <filesystem>

namespace clogflow {

struct Packing {
  std::filesystem::path folder;  ///< of one finished ensemble
  std::filesystem::path pack;    ///< file to write
  bool remove = false;           ///< the run files, when each was compared with its copy
};

/// Writes the pack beside its name, renames it when it is whole, reads it again and compares every run with its file.
/// ensemble.csv goes with it. Removes what it packed, if asked to, and the folder if nothing else is in it.
/// \return number of runs
/// \throws Error for an ensemble that is not finished, a file that cannot be read or written, or a pack that is there
///         already; then nothing is removed
std::size_t pack_ensemble(const Packing& job);

}  // namespace clogflow
