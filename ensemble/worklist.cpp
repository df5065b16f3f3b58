#include "ensemble/worklist.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>
#include <utility>

#include <pwd.h>
#include <unistd.h>

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"

namespace clogflow {

namespace {

/// Ranks that stay to the end and take over what dead ranks leave: enough of them, and few for the directory.
constexpr int most_staying = 64;

/// Between two looks at what others do: a share of the time so far, which adds no more than that share to it.
constexpr double pause_share = 0.005, shortest_pause = 0.01, longest_pause = 5;  // [-] [s] [s]

/// In which a request to stop is noticed [s]
constexpr double slice = 0.05;

std::string user_name() {
  const passwd* user = ::getpwuid(::geteuid());
  return user ? user->pw_name : std::to_string(::geteuid());
}

std::filesystem::path failure_file(std::filesystem::path run_file) { return run_file.replace_extension(".failed"); }

}  // namespace

std::vector<Job> jobs_of(const std::vector<Ensemble>& ensembles) {
  struct Placed {
    Job job;
    std::size_t position;
  };
  std::vector<Placed> placed;
  for (std::size_t k = 0; k < ensembles.size(); ++k) {
    const auto& seeds = ensembles[k].scene.ensemble.seeds;
    for (std::size_t i = 0; i < seeds.size(); ++i) placed.push_back({{k, seeds[i]}, ensembles[k].wanted ? i : 0});
  }
  std::ranges::stable_sort(placed, [&](const Placed& a, const Placed& b) {
    if (a.position != b.position) return a.position < b.position;
    return ensembles[a.job.ensemble].cost > ensembles[b.job.ensemble].cost;
  });
  std::vector<Job> jobs;
  for (const Placed& each : placed) jobs.push_back(each.job);
  return jobs;
}

Worklist::Worklist(Call call)
    : call_(std::move(call)),
      jobs_(jobs_of(call_.ensembles)),
      settled_(jobs_.size(), 0),
      position_(static_cast<std::size_t>(call_.launch.rank)) {}

void Worklist::look() {
  if (!call_.ranks) return;
  // One rank looks, so that all agree.
  for (std::size_t k = 0; k < jobs_.size() && call_.ranks->is_first(); ++k) done_before_ += has_result(k) ? '1' : '0';
  done_before_ = call_.ranks->of_first(done_before_);
}

std::size_t Worklist::not_done_before() const {
  return static_cast<std::size_t>(std::ranges::count(done_before_, '0'));
}

std::vector<Job> Worklist::done_before() {
  std::vector<Job> done;
  const auto count = static_cast<std::size_t>(call_.launch.count);
  for (auto k = static_cast<std::size_t>(call_.launch.rank); k < jobs_.size(); k += count) {
    if (SeedLock::is_there(file(k)) && (!call_.ranks || done_before_[k] == '1')) claim(k);
    if (call_.ranks ? done_before_[k] == '1' : has_result(k)) {
      done.push_back(jobs_[k]);
      settled_[k] = 1;
    }
  }
  return done;
}

std::optional<Claim> Worklist::next_of_counter() {
  while (!must_stop()) {
    const auto k = static_cast<std::size_t>(call_.ranks->next());
    if (k >= jobs_.size()) break;
    if (done_before_[k] == '1' || settled_[k] || is_done_elsewhere(k) || !is_wanted(k)) continue;
    if (auto mine = claim(k)) return mine;
    if (settled_[k] || is_done_elsewhere(k) || !is_wanted(k)) continue;
    settled_[k] = 1;
    const std::string holder = SeedLock::holder(file(k));
    other_ = holder.substr(holder.find(' ') + 1);
    ++left_to_others_;
    call_.awaited(jobs_[k], other_);
  }
  return {};
}

bool Worklist::is_done_elsewhere(std::size_t k) {
  if (!has_result(k)) return false;
  settled_[k] = 1;
  call_.found(jobs_[k]);
  return true;
}

bool Worklist::is_wanted(std::size_t k) const { return !ensemble(k).wanted || ensemble(k).wanted(jobs_[k].seed); }

std::optional<Claim> Worklist::next() {
  if (call_.ranks) return next_of_counter();
  while (!open_ && !must_stop()) {
    const std::size_t k = first_free(position_);
    if (k >= jobs_.size()) break;
    position_ = k + 1;
    if (auto mine = claim(k)) return mine;
  }
  return next_left();
}

/// Doubles its stride until it meets a free job, then halves the gap.
std::size_t Worklist::first_free(std::size_t from) const {
  const std::size_t n = jobs_.size();
  if (from >= n || !is_taken(from)) return from;
  std::size_t taken = from, stride = 1;
  while (taken + stride < n && is_taken(taken + stride)) taken += stride, stride *= 2;
  std::size_t free = std::min(taken + stride, n);
  while (free - taken > 1) {
    const std::size_t middle = taken + (free - taken) / 2;
    (is_taken(middle) ? taken : free) = middle;
  }
  return free;
}

bool Worklist::has_result(std::size_t k) const {
  const Ensemble& e = ensemble(k);
  std::error_code ignored;
  return std::filesystem::exists(file(k), ignored) ||
         (e.wanted && std::filesystem::exists(ahead_file(e, jobs_[k].seed), ignored));
}

bool Worklist::is_settled(std::size_t k) const {
  if (settled_[k] || has_result(k)) return true;
  if (!is_wanted(k)) return true;
  std::ifstream failure(failure_file(file(k)));
  std::string call;
  return std::getline(failure, call) && call == call_.launch.call;
}

/// Its process may be killed between the result and the end of its lock.
bool Worklist::is_over(std::size_t k) const { return settled_[k] || (is_settled(k) && !SeedLock::is_there(file(k))); }

std::optional<Claim> Worklist::claim(std::size_t k) {
  try {
    auto lock = SeedLock::take(file(k), fmt::format("{} process {} of user {} on {}", call_.launch.call, ::getpid(),
                                                    user_name(), call_.launch.host));
    if (!lock) return {};
    if (!lock->works()) {
      without_locks_ = true;
      if (!call_.ranks &&
          k % static_cast<std::size_t>(call_.launch.count) != static_cast<std::size_t>(call_.launch.rank))
        settled_[k] = 1;
    }
    if (is_settled(k)) {
      // Its process died, or was about to end, after the result: what else it left is of no use.
      std::error_code ignored;
      if (std::filesystem::exists(file(k), ignored)) remove_states(ensemble(k), jobs_[k].seed);
      return {};
    }
    return Claim{jobs_[k], std::move(*lock)};
  } catch (const std::exception& error) {
    settled_[k] = 1;
    call_.refused(jobs_[k], error.what());
    return {};
  }
}

std::optional<Claim> Worklist::next_left() {
  if (!open_) {
    open_.emplace();
    for (std::size_t k = 0; k < jobs_.size() && call_.launch.rank < most_staying; ++k)
      if (!settled_[k]) open_->push_back(k);
  }
  while (!open_->empty() && !must_stop()) {
    const std::size_t i = static_cast<std::size_t>(call_.launch.rank) % open_->size(), k = (*open_)[i];
    auto mine = is_over(k) ? std::nullopt : claim(k);
    const Look seen = mine ? Look::settled : look(k);
    if (seen == Look::settled)
      open_->erase(open_->begin() + static_cast<std::ptrdiff_t>(i));
    else if (seen == Look::busy_here || std::exchange(seen_elsewhere_, k) != k) {
      pause();
    } else if (ensemble(k).wanted) {
      // The decision needs it, whoever has it.
      if (std::exchange(awaited_, k) != k) call_.awaited(jobs_[k], other_);
      pause();
    } else {
      ++left_to_others_;
      settled_[k] = 1;
    }
    if (mine) return mine;
  }
  return {};
}

Worklist::Look Worklist::look(std::size_t k) {
  if (is_over(k)) return Look::settled;
  const std::string holder = SeedLock::holder(file(k));
  // Without a line somebody is just taking it or leaving it.
  if (holder.empty() || holder.starts_with(call_.launch.call + " ")) return Look::busy_here;
  other_ = holder.substr(holder.find(' ') + 1);
  return Look::busy_elsewhere;
}

void Worklist::settle(const Job& job) {
  for (std::size_t k = 0; k < jobs_.size(); ++k)
    if (jobs_[k].ensemble == job.ensemble && jobs_[k].seed == job.seed) settled_[k] = 1;
}

void Worklist::mark_failed(const Job& job, const std::string& reason) const {
  const auto mark = failure_file(run_file(call_.ensembles[job.ensemble], job.seed));
  try {
    publish_file(call_.launch.call + "\n" + reason + "\n", mark);
  } catch (const std::exception&) {
    // Without the mark another rank tries the seed again, and says why it fails.
  }
}

void Worklist::forget_failure(const Job& job) const {
  std::error_code ignored;
  std::filesystem::remove(failure_file(run_file(call_.ensembles[job.ensemble], job.seed)), ignored);
}

std::optional<std::string> Worklist::failed_before(const Job& job) const {
  std::ifstream mark(failure_file(run_file(call_.ensembles[job.ensemble], job.seed)));
  std::string call, reason;
  if (!std::getline(mark, call)) return {};
  std::getline(mark, reason);
  return reason;
}

bool Worklist::is_complete() const {
  for (std::size_t k = 0; k < jobs_.size(); ++k)
    if (!is_settled(k)) return false;
  return true;
}

bool Worklist::must_stop() const {
  return std::ranges::any_of(call_.ensembles, [](const Ensemble& e) { return e.stop && e.stop->load(); });
}

void Worklist::pause() const {
  const double wanted = std::clamp(pause_share * watch_.seconds(), shortest_pause, longest_pause);
  for (double slept = 0; slept < wanted && !must_stop(); slept += slice)
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(slice, wanted)));
}

}  // namespace clogflow
