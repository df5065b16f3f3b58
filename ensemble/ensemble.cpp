#include "ensemble/ensemble.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "ensemble/ledger.hpp"

namespace clogflow {

namespace {

const char* word_for(SeedEnd end) {
  switch (end) {
    case SeedEnd::done:
      return "done";
    case SeedEnd::failed:
      return "failed";
    case SeedEnd::stopped:
      return "stopped";
    case SeedEnd::left:
      return "left";
  }
  return "";
}

/// To rename a file takes no longer.
constexpr int most_tries = 500;
constexpr std::chrono::milliseconds between_tries{10};

/// One rank of the call.
class Rank {
public:
  Rank(const EnsembleCall& call, const Watcher& watcher, const Reporter& report)
      : call_(call),
        watcher_(watcher),
        report_(report),
        ledger_(call.ledger, call.launch),
        worklist_({call.ensembles, call.launch, [this](const Job& job, const std::string& why) { refused(job, why); },
                   [this](const Job& job, const std::string& who) {
                     if (call_.launch.rank == 0)
                       tell(job, {job.seed, fmt::format("{} is at work on it; waits for that", who), false, true});
                   }}) {
    for (const Ensemble& ensemble : call.ensembles) {
      make_directory(ensemble.directory);
      inputs_.push_back(inputs_hash(ensemble));
    }
  }

  EnsembleResult work() {
    const Stopwatch watch;
    if (call_.launch.rank == 0) say_what_failed_before();
    set_aside_what_is_short();
    for (const Job& job : worklist_.done_before()) look_at(job);
    while (const auto claim = worklist_.next()) {
      if (worklist_.without_locks() && !std::exchange(said_without_locks_, true))
        report_({claim->job.seed,
                 "the directory is on a file system without locks: every rank does its own share of the seeds, "
                 "and no second call may work here",
                 false, true, ensemble_of(claim->job).name});
      if (run(claim->job) == SeedEnd::stopped) break;
    }
    const Ledger::Sum sum = call_.launch.count > 1 ? ledger_.sum(asked_for()) : Ledger::Sum{};
    return {.failed = std::max(sum.failed, failed_),
            .complete = worklist_.is_complete(),
            .left_to_others = worklist_.left_to_others(),
            .other = worklist_.other(),
            .unrecorded = unrecorded_,
            .busy = sum.busy,
            .duration = watch.seconds()};
  }

private:
  const Ensemble& ensemble_of(const Job& job) const { return call_.ensembles[job.ensemble]; }

  /// This call tries them again, whatever its name: names of calls repeat in containers.
  void say_what_failed_before() const {
    for (const Job& job : jobs_of(call_.ensembles))
      if (const auto reason = worklist_.failed_before(job)) {
        tell(job, {job.seed, fmt::format("failed before ({}); is tried again", *reason), false, true});
        worklist_.forget_failure(job);
      }
  }

  std::set<std::string> asked_for() const {
    std::set<std::string> seeds;
    for (const Job& job : jobs_of(call_.ensembles)) seeds.insert(Ledger::name_of(ensemble_of(job).name, job.seed));
    return seeds;
  }

  /// Before any work begins, so that what stands as a run file is done. Rank 0 looks at all, since it must not end
  /// before others have begun.
  void set_aside_what_is_short() {
    const std::vector<Job> jobs = jobs_of(call_.ensembles);
    const auto [rank, count] = std::pair(call_.launch.rank, static_cast<std::size_t>(call_.launch.count));
    for (std::size_t k = static_cast<std::size_t>(rank); k < jobs.size(); k += rank == 0 ? 1 : count)
      set_aside_if_short(ensemble_of(jobs[k]), inputs_[jobs[k].ensemble], jobs[k].seed);
  }

  static void set_aside_if_short(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed) {
    try {
      const StateOwner owner = owner_of(ensemble, inputs, seed);
      const auto is_to_go = [&](const std::optional<Done>& done) {
        return done && done->shorter && done->file != shorter_file(ensemble, seed);
      };
      // Who else has the lock is doing the same.
      for (int tries = 0; is_to_go(find_done(ensemble, owner)) && tries < most_tries; ++tries) {
        const auto lock = SeedLock::take(run_file(ensemble, seed), "");
        if (!lock)
          std::this_thread::sleep_for(between_tries);
        else if (const auto done = find_done(ensemble, owner); is_to_go(done))
          set_aside(ensemble, owner, *done);
      }
    } catch (const std::exception&) {
      // Said when the seed's turn comes.
    }
  }

  /// What was done before needs no entry, unless it is not what it should be.
  void look_at(const Job& job) {
    const Stopwatch watch;
    if (attempt(job) == SeedEnd::failed) enter(job, watch, SeedEnd::failed);
  }

  SeedEnd run(const Job& job) {
    const Stopwatch watch;
    const SeedEnd end = attempt(job);
    enter(job, watch, end);
    return end;
  }

  SeedEnd attempt(const Job& job) {
    std::string last;
    const SeedEnd end =
        run_locked_seed(ensemble_of(job), inputs_[job.ensemble], job.seed, watcher_, [&](const SeedReport& said) {
          last = said.line;
          tell(job, said);
        });
    if (end == SeedEnd::failed) fail(job, last);
    if (end == SeedEnd::done) worklist_.forget_failure(job);
    if (end != SeedEnd::stopped) worklist_.settle(job);
    return end;
  }

  void refused(const Job& job, const std::string& why) {
    ++failed_;
    tell(job, {job.seed, why, true});
    enter(job, Stopwatch(), SeedEnd::failed);
  }

  void fail(const Job& job, const std::string& why) {
    ++failed_;
    std::error_code ignored;
    // A file that is no result of this scene stays as it is, without a mark beside it.
    if (!std::filesystem::exists(run_file(ensemble_of(job), job.seed), ignored)) worklist_.mark_failed(job, why);
  }

  void tell(const Job& job, SeedReport said) const {
    said.point = ensemble_of(job).name;
    report_(said);
  }

  void enter(const Job& job, const Stopwatch& watch, SeedEnd end) {
    try {
      ledger_.append({ensemble_of(job).name, job.seed, watch.began(), watch.began() + watch.seconds(), word_for(end)});
    } catch (const std::exception& error) {
      // A disk that stays full is said once.
      if (unrecorded_++ == 0) tell(job, {job.seed, error.what(), false, true});
    }
  }

  const EnsembleCall& call_;
  const Watcher& watcher_;
  const Reporter& report_;
  Ledger ledger_;
  Worklist worklist_;
  std::vector<std::string> inputs_;
  std::size_t failed_ = 0, unrecorded_ = 0;
  bool said_without_locks_ = false;
};

}  // namespace

std::vector<std::string> check_directories(const EnsembleCall& call) {
  std::vector<std::string> lines;
  for (const Ensemble& ensemble : call.ensembles) {
    std::error_code ignored;
    if (!std::filesystem::exists(ensemble.directory, ignored)) continue;
    if (std::string line = check_directory(ensemble, inputs_hash(ensemble)); !line.empty())
      lines.push_back(std::move(line));
  }
  return lines;
}

EnsembleResult run_ensembles(const EnsembleCall& call, const Watcher& watcher, const Reporter& report) {
  return Rank(call, watcher, report).work();
}

}  // namespace clogflow
