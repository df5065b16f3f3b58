// clog run: the particles, for every seed asked for.

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <sys/time.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/display.hpp"
#include "cli/output.hpp"
#include "cli/run_points.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "dem/kernels/kernels.hpp"
#include "ensemble/ensemble.hpp"

namespace clogflow::cli {
namespace {

/// Time for rank 0 to say what all ranks would say, and to be ended by the launcher for it.
constexpr std::chrono::seconds rank_0_speaks_within{5};

/// Some 30 years; a timer counts whole seconds, and not every number is one [s].
constexpr double longest_time_limit = 1e9;

/// More are a mistake of a digit.
constexpr int most_threads = 1024;

struct RunOptions {
  RunSource source;
  std::filesystem::path out;
  std::string tolerance, time_limit, until;
  Ranks::Use use = Ranks::Use::mpi;
  int threads = 1;
};

/// Without MPI rank 0 speaks for all processes that meet the same problem, and its end ends them; one that is alone
/// with its problem says so.
template <class Work>
auto without_mpi(const Launch& launch, const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    const auto end = std::chrono::steady_clock::now() + rank_0_speaks_within;
    while (launch.rank != 0 && !stop_asked && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    throw Error(stop_asked && launch.rank != 0 ? "" : error.what());
  }
}

/// From now on; asks to stop like a signal of the user.
void stop_after(const std::string& limit) {
  const std::string meaning = fmt::format("a positive time below {:.0g} s, such as '55 min'", longest_time_limit);
  const double seconds = parse_option("--time-limit", limit, dimension::time, meaning);
  require(seconds > 0 && seconds < longest_time_limit, "--time-limit {} (must be {})", limit, meaning);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds)));
  if (timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0) timer.it_value.tv_usec = 1;
  require(::setitimer(ITIMER_REAL, &timer, nullptr) == 0, "--time-limit {} (the system has no such timer)", limit);
}

void say(const SeedReport& report) {
  const std::string line =
      fmt::format("{}seed {}: {}", report.point.empty() ? "" : report.point + ", ", report.seed, report.line);
  if (report.failed) return print_error(line);
  if (report.note) return print_note(line);
  print_result("{}\n", line);
}

/// The points on every rank.
std::vector<RunPoint> points_for(const RunOptions& options, const Launch& launch, Ranks& ranks) {
  const auto read = [&] {
    select_kernels();  // says what is wrong with CLOG_ISA
    return read_run_points(options.source);
  };
  if (options.use == Ranks::Use::none) return without_mpi(launch, read);
  std::vector<RunPoint> points;
  ranks.together([&] {
    if (ranks.is_first()) points = read();
  });
  return shared_run_points(std::move(points), options.source.scene, ranks);
}

EnsembleCall call_for(const std::vector<RunPoint>& points, const RunOptions& options, const Launch& launch,
                      Ranks& ranks) {
  EnsembleCall call{.ensembles = {},
                    .launch = launch,
                    .ranks = options.use == Ranks::Use::none ? nullptr : &ranks,
                    .ledger = options.out / "ensemble.csv"};
  for (const RunPoint& p : points) {
    if (launch.rank == 0 && !p.note.empty()) print_words("{}{}\n", p.folder.empty() ? "" : p.folder + ": ", p.note);
    call.ensembles.push_back(
        {p.scene, p.flow.get(), options.out / p.folder, &stop_asked, p.folder, p.cost, options.threads});
    call.inputs.push_back(p.inputs);
  }
  return call;
}

/// That the directories belong to the scene, and are there.
void prepare_directories(const EnsembleCall& call) {
  const auto prepare = [&] {
    for (const std::string& line : check_directories(call))
      if (call.launch.rank == 0) print_note(line);
    for (const Ensemble& ensemble : call.ensembles) make_directory(ensemble.directory);
    return true;
  };
  if (!call.ranks)
    without_mpi(call.launch, prepare);
  else
    call.ranks->together([&] {
      if (call.ranks->is_first()) prepare();
    });
}

using Decisions = std::vector<std::unique_ptr<EnoughSeeds>>;

/// One decision an ensemble, or none.
Decisions make_decisions(const std::string& until, EnsembleCall& call) {
  Decisions decisions;
  const postprocess::StoppingRule rule(until);
  const auto learns = call.ranks ? EnoughSeeds::Learns::from_ranks : EnoughSeeds::Learns::from_files;
  for (Ensemble& ensemble : call.ensembles) {
    decisions.push_back(std::make_unique<EnoughSeeds>(rule, ensemble, learns));
    call.decisions.push_back(decisions.back().get());
    ensemble.wanted = [decision = decisions.back().get()](std::uint64_t seed) { return decision->wanted(seed); };
  }
  return decisions;
}

Decisions decide_by(const std::string& until, EnsembleCall& call) {
  if (until.empty()) return {};
  if (!call.ranks) return without_mpi(call.launch, [&] { return make_decisions(until, call); });
  Decisions decisions;
  call.ranks->together([&] { decisions = make_decisions(until, call); });
  return decisions;
}

/// What was decided. \throws Error if more seeds are needed than were allowed
void say(const Decisions& decisions, const EnsembleCall& call, const EnsembleResult& result) {
  std::vector<std::string> not_met;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    const std::string& point = call.ensembles[i].name;
    const std::string line = (point.empty() ? "" : point + ": ") + decisions[i]->summary();
    if (decisions[i]->is_met())
      print_result("{}\n", line);
    else if (result.left_to_others > 0)
      print_result("{} so far: other calls are at work on some of them\n", line);
    else if (result.stopped > 0)
      print_result("{} so far: stopped, the same call goes on\n", line);
    else
      not_met.push_back(line);
  }
  require(not_met.empty() || stop_asked, "{}: give more --seeds", fmt::join(not_met, "; "));
}

/// The last words of rank 0, which stays until everything is settled. The others end with status 0 whatever
/// happened to their seeds: launchers kill all ranks when one ends otherwise.
void conclude(const EnsembleCall& call, const EnsembleResult& result, const std::filesystem::path& out) {
  if (call.launch.rank != 0) return;
  std::size_t seeds = 0;
  for (const Ensemble& ensemble : call.ensembles) seeds += ensemble.scene.ensemble.seeds.size();
  if (call.launch.count > 1 && result.busy > 0)
    print_words("{} ranks, busy {:.1f} % of {:.1f} s\n", call.launch.count,
                100 * result.busy / (result.duration * call.launch.count), result.duration);
  if (stop_asked && result.begun == 0 && result.to_do > 0)
    print_result("stopped before any seed began: the same call begins\n");
  if (result.left_to_others > 0)
    print_result("{} of {} seeds are left to other calls that are at work on them{}{}\n", result.left_to_others, seeds,
                 result.other.empty() ? "" : ", such as ", result.other);
  require(result.failed == 0, "{} of {} seeds failed; the others are in {}", result.failed, seeds, out.string());
  require(result.unrecorded == 0, "{} seeds are done but not listed in {}", result.unrecorded, call.ledger.string());
}

void run_on(const RunOptions& options, Ranks& ranks) {
  ranks.together([&] {
    if (!options.time_limit.empty()) stop_after(options.time_limit);
  });
  const Launch launch = options.use == Ranks::Use::none ? launch_from_environment() : launch_of(ranks);
  const auto points = points_for(options, launch, ranks);
  EnsembleCall call = call_for(points, options, launch, ranks);
  const Decisions decisions = decide_by(options.until, call);
  prepare_directories(call);
  Display display(launch);
  const EnsembleResult result = run_ensembles(
      call, {.report =
                 [&](const SeedReport& report) {
                   display.clear();
                   say(report);
                 },
             .progress = [&](const Progress& progress, const Standing& all) { display.show(progress, all); }});
  display.clear();
  ranks.together([&] {
    for (const auto& decision : decisions) decision->settle(ranks.rank(), ranks.count());
  });
  ranks.part();
  conclude(call, result, options.out);
  if (launch.rank == 0) say(decisions, call, result);
  // Not for ranks: launchers kill all when one ends otherwise, and may meet the others at saving their states.
  if (!result.complete && !launch.by_launcher && (stop_signal == SIGINT || stop_signal == SIGTERM))
    throw EndWithStatus{128 + stop_signal};
}

void run(const RunOptions& options) {
  require(options.threads >= 1 && options.threads <= most_threads, "--threads {} (must be 1 to {})", options.threads,
          most_threads);
  stop_at({SIGTERM, SIGINT, SIGALRM});
  Ranks ranks(options.use);
  ranks.run([&] { run_on(options, ranks); });
}

}  // namespace

void add_run(CLI::App& app) {
  auto* verb = app.add_subcommand("run", "push the particles through: one file per seed");
  auto options = std::make_shared<RunOptions>();
  verb->add_option("scene", options->source.scene, "scene file (TOML)")->required();
  verb->add_option("--flow", options->source.flow, "flow.h5 made by clog map");
  verb->add_option("--seeds", options->source.seeds, "for example 1-40; default: ensemble.seeds");
  verb->add_option("--sweep", options->source.sweeps, "key=value,value: a folder for every value; again for every key")
      ->allow_extra_args(false);
  verb->add_option("--out", options->out, "directory for the run files")->required();
  verb->add_option("--tolerance", options->tolerance,
                   "let the program choose the cheapest numerics measured to be within this, such as 0.05");
  verb->add_option("--time-limit", options->time_limit,
                   "stop after this time, such as '55 min', with every state saved; the same call goes on");
  verb->add_option("--until", options->until,
                   "use only as many of the seeds, in their order, as are enough: 'bursts>=1000', "
                   "'relative_error(mean_burst)<=0.05'")
      ->option_text("RULE");
  verb->add_option("--set", options->source.overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->add_option("--threads", options->threads,
                   "of each run, for runs of more than some ten thousand particles; the same bits for any number");
  verb->add_flag_callback(
      "--no-mpi", [options] { options->use = Ranks::Use::none; },
      "under mpirun or srun: processes that share the seeds through files alone; one that dies stops no other");
  verb->callback([options] {
    if (!options->tolerance.empty()) options->source.overrides.push_back("fidelity.tolerance=" + options->tolerance);
    run(*options);
  });
}

}  // namespace clogflow::cli
