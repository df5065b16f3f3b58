#include <mpi.h>

#include "coupling/base/environment.hpp"
#include "ensemble/ranks.hpp"

namespace clogflow {

struct Ranks::Shared {
  MPI_Win window;
  int* counter;
};

namespace {

/// MPI is started only under mpirun or srun: a lone process needs none of it.
bool launched_by_mpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (environment(name)) return true;
  return false;
}

}  // namespace

Ranks::Ranks() {
  if (!launched_by_mpi()) return;
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  shared_ = new Shared;
  // The counter lives on rank 0; the others change it without its help.
  MPI_Win_allocate(rank_ == 0 ? sizeof(int) : 0, sizeof(int), MPI_INFO_NULL, MPI_COMM_WORLD, &shared_->counter,
                   &shared_->window);
  if (rank_ == 0) *shared_->counter = 0;
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Win_lock_all(0, shared_->window);
}

Ranks::~Ranks() {
  if (!shared_) return;
  MPI_Win_unlock_all(shared_->window);
  MPI_Win_free(&shared_->window);
  delete shared_;
  MPI_Finalize();
}

int Ranks::next() {
  if (!shared_) return taken_++;
  const int one = 1;
  int mine = 0;
  MPI_Fetch_and_op(&one, &mine, MPI_INT, 0, 0, MPI_SUM, shared_->window);
  MPI_Win_flush(0, shared_->window);
  return mine;
}

int Ranks::sum(int value) {
  if (!shared_) return value;
  int total = 0;
  MPI_Allreduce(&value, &total, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  return total;
}

int Ranks::least(int value) {
  if (!shared_) return value;
  int least = 0;
  MPI_Allreduce(&value, &least, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return least;
}

}  // namespace clogflow
