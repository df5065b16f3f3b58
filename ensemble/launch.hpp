// Which of the processes of a job this one is.
#pragma once

#include <string>

namespace clogflow {

/// The ranks of an ensemble share a directory and no messages, so a rank that dies can neither stop nor hang
/// the others. All that a launcher (mpirun, srun) has to tell is in the environment.
struct Launch {
  int rank = 0, count = 1;
  bool by_launcher = false;
  std::string call;  ///< the same for all ranks of one call and for no other call, requeued jobs included
  std::string host;
};

/// A process that no launcher started is rank 0 of 1. \throws Error if the environment contradicts itself
Launch launch_from_environment();

}  // namespace clogflow
