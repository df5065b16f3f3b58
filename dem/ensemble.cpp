#include "dem/ensemble.hpp"

#include <algorithm>

#include "dem/ledger.hpp"

namespace clog {

namespace {

const char* word_for(SeedEnd end) {
  switch (end) {
    case SeedEnd::done: return "done";
    case SeedEnd::failed: return "failed";
    case SeedEnd::stopped: return "stopped";
    case SeedEnd::left: return "left";
  }
  return "";
}

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
    const double began = seconds_now();
    for (const Job& job : worklist_.done_before()) look_at(job);
    while (const auto claim = worklist_.next()) {
      if (worklist_.without_locks() && !std::exchange(said_without_locks_, true))
        report_({claim->job.seed,
                 "the directory is on a file system without locks: every rank does its own share of the seeds, "
                 "and no second call may work here",
                 false, true, ensemble_of(claim->job).name});
      if (run(claim->job) == SeedEnd::stopped) break;
    }
    const Ledger::Sum sum = ledger_.sum();
    return {std::max(sum.failed, failed_), worklist_.left_to_others(), worklist_.other(), unrecorded_, sum.busy,
            seconds_now() - began};
  }

private:
  const Ensemble& ensemble_of(const Job& job) const { return call_.ensembles[job.ensemble]; }

  /// What was done before needs no entry, unless it is not what it should be.
  void look_at(const Job& job) {
    const double began = seconds_now();
    if (attempt(job) == SeedEnd::failed) enter(job, began, SeedEnd::failed);
  }

  SeedEnd run(const Job& job) {
    const double began = seconds_now();
    const SeedEnd end = attempt(job);
    enter(job, began, end);
    return end;
  }

  SeedEnd attempt(const Job& job) {
    std::string last;
    const SeedEnd end = run_locked_seed(ensemble_of(job), inputs_[job.ensemble], job.seed, watcher_,
                                        [&](const SeedReport& said) {
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
    enter(job, seconds_now(), SeedEnd::failed);
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

  void enter(const Job& job, double began, SeedEnd end) {
    try {
      ledger_.append({ensemble_of(job).name, job.seed, began, seconds_now(), word_for(end)});
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

EnsembleResult run_ensembles(const EnsembleCall& call, const Watcher& watcher, const Reporter& report) {
  return Rank(call, watcher, report).work();
}

}  // namespace clog
