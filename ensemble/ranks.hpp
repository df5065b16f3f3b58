// The processes of one MPI job: who they are, what they tell each other, and how they wait.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace clogflow {

/// The ranks of the job that this process belongs to. A process that neither mpirun nor srun started is a job of one
/// rank and needs no MPI. A run never uses more than one rank, so its result does not depend on their number.
///
/// A rank computes for minutes between two calls of MPI; what others want of it meanwhile (its memory, lines for
/// rank 0, sums) comes about only while it is inside MPI. serve() is that: to be called many times a second.
class Ranks {
public:
  enum class Use { mpi, none };

  /// \throws Error if a launcher started several processes that MPI would not bring together
  explicit Ranks(Use use = Use::mpi);
  /// All ranks together, as with everything here that says so.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }
  bool is_first() const { return rank_ == 0; }
  bool launched() const { return job_ != nullptr; }  ///< by mpirun or srun

  /// The next number of a counter that all ranks share, 0, 1, 2 ... It lies on rank 0, which need not help where there
  /// is one-sided communication, as within a node; elsewhere it answers when it serves.
  int next();

  /// Lets the others reach this rank. Ends the job when a process of this node has died, for which they would wait.
  void serve();

  /// A line for rank 0, in the order of this rank's lines; it does not wait.
  void tell_first(const std::string& line);
  /// On rank 0: what has come since, in no order between ranks.
  std::vector<std::string> told();

  /// A sum over all ranks that comes about while they compute. All ranks together, one after the other.
  void begin_sum(std::vector<double> mine);
  /// Nothing while a rank has not begun its own, or none is under way.
  std::optional<std::vector<double>> ended_sum();

  /// Does the work on every rank, and fails on all if it fails on one: the first of those keeps its words, the others
  /// throw an empty Error. All ranks together.
  void together(const std::function<void()>& work);

  /// The text of rank 0. All ranks together.
  std::string of_first(std::string text);

  /// The numbers of rank 0, once in the memory of each node. All ranks together.
  /// \throws Error if a node has no room for them in shared memory
  std::shared_ptr<const float[]> once_per_node(std::span<const float> of_first);

  /// Until all ranks have come here; the lines of the others reach rank 0 before. All ranks together.
  /// \param meanwhile  done at least 50 times a second
  void wait(const std::function<void()>& meanwhile = {});

  /// From now on no rank waits for another but in the end of the job. So it is too when together() has failed.
  void part() { parted_ = true; }

  /// The work of this rank. If it throws while others may wait for it the whole job ends, with its words.
  void run(const std::function<void()>& work);

private:
  void abandon(const std::string& why);

  struct Job;
  std::unique_ptr<Job> job_;  // nothing: alone
  int rank_ = 0, count_ = 1, taken_ = 0;
  bool parted_ = false;
  std::optional<std::vector<double>> alone_;  // the sum of a job of one
};

}  // namespace clogflow
