// Which of the processes of a job this one is.
#pragma once

#include <string>

#include "ensemble/ranks.hpp"

namespace clogflow {

struct Launch {
  int rank = 0, count = 1;
  bool by_launcher = false;
  std::string call;  ///< the same for all ranks of one call and for no other call, requeued jobs included
  std::string host;
};

/// All ranks together.
Launch launch_of(Ranks& ranks);

/// Without MPI (--no-mpi) the processes share a directory and no messages, so one that dies can neither stop nor hang
/// the others. All that a launcher (mpirun, srun) has to tell is in the environment. A process that no launcher started
/// is rank 0 of 1. \throws Error if the environment contradicts itself
Launch launch_from_environment();

}  // namespace clogflow
