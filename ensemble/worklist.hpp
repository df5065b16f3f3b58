// The jobs of a call, shared by processes that know each other only through the directory.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ensemble/launch.hpp"
#include "ensemble/ledger.hpp"
#include "ensemble/seed_files.hpp"
#include "ensemble/seed_lock.hpp"
#include "ensemble/seed_run.hpp"

namespace clogflow {

/// One seed of one of the ensembles.
struct Job {
  std::size_t ensemble;
  std::uint64_t seed;
};

/// All seeds of all ensembles, the longest first, so that no rank begins a long run when the others are done.
/// Seeds that run ahead of a decision come in their order, so that few of them run in vain.
std::vector<Job> jobs_of(const std::vector<Ensemble>& ensembles);

/// A job and the right to do it.
struct Claim {
  Job job;
  SeedLock lock;
};

/// Hands out what nobody has done and nobody is at work on. The lock decides between calls.
///
/// Ranks of an MPI job take the jobs in order, from a counter; what another call has is left to it.
/// Without MPI a free job is found by about log(jobs) looks at the directory, since jobs are taken in order. What a
/// dead process left is found at the end, by the processes that stay until everything is settled.
class Worklist {
public:
  struct Call {
    const std::vector<Ensemble>& ensembles;
    const Launch& launch;
    Ranks* ranks;  ///< nullptr: without MPI
    using Told = std::function<void(const Job&, const std::string&)>;
    Told refused;                           ///< a job that cannot be claimed, and why
    Told awaited;                           ///< a job that must be waited for, or is left, and who has it
    std::function<void(const Job&)> found;  ///< with MPI: a job that another call did meanwhile
  };
  explicit Worklist(Call call);

  /// With MPI, all ranks together: what is done when the call begins.
  void look();

  /// Jobs that were not done when the call began; with MPI only.
  std::size_t not_done_before() const;

  /// The jobs of this rank's share that were done before, to be checked; what dead processes left locked is
  /// unlocked.
  std::vector<Job> done_before();

  /// Without MPI it waits while others are at work on the last jobs. Nothing when all are settled or the call must
  /// stop.
  std::optional<Claim> next();

  /// This process is not to try the job again.
  void settle(const Job& job);

  /// No rank of this call is to try it again: it leaves its reason in run_NNNN.failed, which the next call
  /// does not heed.
  void mark_failed(const Job& job, const std::string& reason) const;
  void forget_failure(const Job& job) const;

  /// Why it failed at another time, if it did.
  std::optional<std::string> failed_before(const Job& job) const;

  /// Whether nothing is left, for this call or another.
  bool is_complete() const;

  /// Jobs that another call is at work on, left to it: how many, and who has one of them.
  int left_to_others() const { return left_to_others_; }
  const std::string& other() const { return other_; }

  /// Whether the directory's file system has no locks: then every rank does its own share.
  bool without_locks() const { return without_locks_; }

  bool must_stop() const;

private:
  enum class Look { settled, busy_here, busy_elsewhere };

  const Ensemble& ensemble(std::size_t k) const { return call_.ensembles[jobs_[k].ensemble]; }
  std::filesystem::path file(std::size_t k) const { return run_file(ensemble(k), jobs_[k].seed); }
  bool has_result(std::size_t k) const;
  bool is_wanted(std::size_t k) const;
  bool is_done_elsewhere(std::size_t k);
  bool is_settled(std::size_t k) const;
  bool is_over(std::size_t k) const;
  bool is_taken(std::size_t k) const { return is_settled(k) || SeedLock::is_there(file(k)); }
  std::size_t first_free(std::size_t from) const;
  std::optional<Claim> claim(std::size_t k);
  std::optional<Claim> next_of_counter();
  std::optional<Claim> next_left();
  Look look(std::size_t k);
  void pause() const;

  Call call_;
  std::vector<Job> jobs_;
  std::vector<std::uint8_t> settled_;             // as far as this process knows
  std::string done_before_;                       // with MPI: "1" where there was a result
  std::size_t position_;                          // where the untouched jobs begin, or before
  std::optional<std::vector<std::size_t>> open_;  // at the end: what is not settled
  std::optional<std::size_t> seen_elsewhere_, awaited_;
  int left_to_others_ = 0;
  std::string other_;
  bool without_locks_ = false;
  Stopwatch watch_;
};

}  // namespace clogflow
