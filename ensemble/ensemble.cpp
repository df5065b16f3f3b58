#include "ensemble/ensemble.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "coupling/base/archive.hpp"
#include "ensemble/ledger.hpp"
#include "ensemble/pulse.hpp"
#include "ensemble/short_runs.hpp"

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

template <class Archive>
void exchange(SeedReport& report, Archive& archive) {
  archive(report.seed, report.line, report.failed, report.note, report.point);
}

/// One rank of the call.
class Rank {
public:
  Rank(const EnsembleCall& call, const Audience& audience)
      : call_(call),
        audience_(audience),
        ledger_(call.ledger, call.launch),
        worklist_({call.ensembles, call.launch, call.ranks,
                   [this](const Job& job, const std::string& why) { refused(job, why); },
                   [this](const Job& job, const std::string& who) { is_elsewhere(job, who); },
                   [this](const Job& job) { was_done_elsewhere(job); }}) {
    if (call.ranks) pulse_.emplace(*call.ranks, call.decisions);
  }

  EnsembleResult work() {
    const Stopwatch watch;
    if (call_.launch.rank == 0) say_what_failed_before();
    set_aside_what_is_short();
    // What was done before is checked before anybody begins, and decides what is begun.
    if (call_.ranks) call_.ranks->wait([this] { hear(); });
    worklist_.look();
    for (const Job& job : worklist_.done_before()) look_at(job);
    if (call_.ranks) {
      mine_.jobs =
          call_.launch.rank == 0 && call_.decisions.empty() ? static_cast<double>(worklist_.not_done_before()) : 0;
      pulse_->settle(mine_);
    }
    while (const auto claim = worklist_.next()) {
      say_without_locks(claim->job);
      if (run(claim->job) == SeedEnd::stopped) break;
    }
    return call_.ranks ? end_together(watch) : end_alone(watch);
  }

private:
  const Ensemble& ensemble_of(const Job& job) const { return call_.ensembles[job.ensemble]; }

  EnsembleResult end_together(const Stopwatch& watch) {
    mine_.left_to_others = worklist_.left_to_others();
    pulse_->finish(mine_, [this] {
      hear();
      if (audience_.progress) audience_.progress({}, pulse_->all());
    });
    call_.ranks->wait([this] { hear(); });
    hear();
    const Standing& all = pulse_->all();
    return {.failed = static_cast<std::size_t>(all.failed),
            // Who asks for a job's status asks the launcher.
            .complete = call_.launch.by_launcher || worklist_.is_complete(),
            .stopped = static_cast<std::size_t>(all.stopped),
            .begun = static_cast<std::size_t>(all.done + all.stopped),
            .to_do = worklist_.not_done_before(),
            .left_to_others = static_cast<int>(all.left_to_others),
            .other = worklist_.other(),
            .unrecorded = unrecorded_,
            .busy = all.busy,
            .duration = watch.seconds()};
  }

  EnsembleResult end_alone(const Stopwatch& watch) const {
    const Ledger::Sum sum = call_.launch.count > 1 ? ledger_.sum(asked_for()) : Ledger::Sum{};
    return {.failed = std::max(sum.failed, static_cast<std::size_t>(mine_.failed)),
            .complete = worklist_.is_complete(),
            .left_to_others = worklist_.left_to_others(),
            .other = worklist_.other(),
            .unrecorded = unrecorded_,
            .busy = sum.busy,
            .duration = watch.seconds()};
  }

  /// This call tries them again, whatever its name: names of calls repeat in containers.
  void say_what_failed_before() {
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

  /// Before any work begins. Without MPI rank 0 looks at all, since it must not end before others have begun.
  void set_aside_what_is_short() {
    const std::vector<Job> jobs = jobs_of(call_.ensembles);
    const auto [rank, count] = std::pair(call_.launch.rank, static_cast<std::size_t>(call_.launch.count));
    for (std::size_t k = static_cast<std::size_t>(rank); k < jobs.size(); k += !call_.ranks && rank == 0 ? 1 : count)
      set_aside_if_short(ensemble_of(jobs[k]), call_.inputs[jobs[k].ensemble], jobs[k].seed);
  }

  /// What was done before needs no entry, unless it is not what it should be.
  void look_at(const Job& job) {
    const Stopwatch watch;
    std::string last;
    const SeedEnd end = check_seed(ensemble_of(job), call_.inputs[job.ensemble], job.seed, [&](const SeedReport& said) {
      last = said.line;
      tell(job, said);
    });
    settle(job, end, last);
    if (end == SeedEnd::failed) enter(job, watch, end);
  }

  SeedEnd run(const Job& job) {
    const Stopwatch watch;
    const double passages_before = mine_.passages;
    const SeedEnd end = attempt(job, [&](const Progress& now) {
      const double seconds = watch.seconds();
      mine_.filling = now.filling, mine_.clogged = !now.filling && now.clogged;
      mine_.flowing = !now.filling && !now.clogged;
      mine_.share = now.filling ? 0 : now.time / now.end;
      mine_.passages = passages_before + static_cast<double>(now.passages);
      mine_.particle_steps = seconds > 0 ? now.particle_steps / seconds : 0;
      look_around(now);
    });
    mine_.filling = mine_.flowing = mine_.clogged = mine_.share = mine_.particle_steps = 0;
    mine_.busy += watch.seconds();
    ++(end == SeedEnd::stopped ? mine_.stopped : mine_.done);
    enter(job, watch, end);
    if (pulse_) pulse_->beat(mine_);
    return end;
  }

  void look_around(const Progress& now) {
    if (pulse_) pulse_->beat(mine_);
    hear();
    if (audience_.progress) audience_.progress(now, pulse_ ? pulse_->all() : Standing{});
  }

  SeedEnd attempt(const Job& job, const Watcher& watcher) {
    std::string last;
    const SeedEnd end =
        run_locked_seed(ensemble_of(job), call_.inputs[job.ensemble], job.seed, watcher, [&](const SeedReport& said) {
          last = said.line;
          tell(job, said);
        });
    settle(job, end, last);
    return end;
  }

  void settle(const Job& job, SeedEnd end, const std::string& last) {
    if (end == SeedEnd::failed) fail(job, last);
    if (end == SeedEnd::done) worklist_.forget_failure(job);
    if (end == SeedEnd::done && !call_.decisions.empty()) call_.decisions[job.ensemble]->is_done(job.seed);
    if (end != SeedEnd::stopped) worklist_.settle(job);
  }

  void refused(const Job& job, const std::string& why) {
    ++mine_.failed, ++mine_.done;
    tell(job, {job.seed, why, true});
    enter(job, Stopwatch(), SeedEnd::failed);
  }

  void is_elsewhere(const Job& job, const std::string& who) {
    if (!call_.ranks) {
      if (call_.launch.rank == 0)
        tell(job, {job.seed, fmt::format("{} is at work on it; waits for that", who), false, true});
      return;
    }
    was_done_elsewhere(job);
  }

  void was_done_elsewhere(const Job& job) {
    ++mine_.done;
    if (!call_.decisions.empty()) call_.decisions[job.ensemble]->is_elsewhere(job.seed);
  }

  void fail(const Job& job, const std::string& why) {
    ++mine_.failed;
    std::error_code ignored;
    // A file that is no result of this scene stays as it is, without a mark beside it.
    if (!std::filesystem::exists(run_file(ensemble_of(job), job.seed), ignored)) worklist_.mark_failed(job, why);
  }

  void say_without_locks(const Job& job) {
    if (!worklist_.without_locks() || std::exchange(said_without_locks_, true)) return;
    if (call_.ranks && !call_.ranks->is_first()) return;
    audience_.report({job.seed,
                      call_.ranks ? "the directory is on a file system without locks: no second call may work here"
                                  : "the directory is on a file system without locks: every rank does its own share of "
                                    "the seeds, and no second call may work here",
                      false, true, ensemble_of(job).name});
  }

  void tell(const Job& job, SeedReport said) const {
    said.point = ensemble_of(job).name;
    if (!call_.ranks || call_.ranks->is_first()) return audience_.report(said);
    ArchiveWriter archive;
    exchange(said, archive);
    call_.ranks->tell_first(archive.bytes());
  }

  /// What other ranks told rank 0.
  void hear() const {
    if (!call_.ranks) return;
    for (const std::string& bytes : call_.ranks->told()) {
      SeedReport said{};
      ArchiveReader archive(bytes);
      exchange(said, archive);
      audience_.report(said);
    }
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
  const Audience& audience_;
  Ledger ledger_;
  Worklist worklist_;
  std::optional<Pulse> pulse_;
  Standing mine_;
  std::size_t unrecorded_ = 0;
  bool said_without_locks_ = false;
};

}  // namespace

std::vector<std::string> check_directories(const EnsembleCall& call) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < call.ensembles.size(); ++k) {
    std::error_code ignored;
    if (!std::filesystem::exists(call.ensembles[k].directory, ignored)) continue;
    if (std::string line = check_directory(call.ensembles[k], call.inputs[k]); !line.empty())
      lines.push_back(std::move(line));
  }
  return lines;
}

EnsembleResult run_ensembles(const EnsembleCall& call, const Audience& audience) {
  // A rank on a node that does not see the folder must not begin.
  for (const Ensemble& ensemble : call.ensembles) make_directory(ensemble.directory);
  return Rank(call, audience).work();
}

}  // namespace clogflow
