// The processes of an MPI job and the counter that they share.
#pragma once

namespace clogflow {

/// The ranks of the job this process belongs to; a lone process is a job of one rank and needs no
/// mpirun. A run never uses more than one rank, so its result does not depend on their number.
class Ranks {
public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }

  /// The next number of a counter that all ranks share, 0, 1, 2 ...; no rank waits for another.
  int next();

  /// Waits for all ranks. \return the sum, or the least, of their values
  int sum(int value);
  int least(int value);

private:
  struct Shared;
  Shared* shared_ = nullptr;
  int rank_ = 0, count_ = 1, taken_ = 0;
};

}  // namespace clogflow
