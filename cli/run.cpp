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

#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "coupling/flow/flow_rescale.hpp"
#include "coupling/scene/sweep.hpp"
#include "dem/kernels/kernels.hpp"
#include "dem/plan/plan.hpp"
#include "dem/stability/step_limit.hpp"
#include "dem/state/initial_particles.hpp"
#include "ensemble/enough_seeds.hpp"
#include "ensemble/ensemble.hpp"
#include "trade/fidelity.hpp"

namespace clogflow::cli {
namespace {

/// Time for rank 0 to say what all ranks would say, and to be ended by the launcher for it.
constexpr std::chrono::seconds rank_0_speaks_within{5};

/// Some 30 years; a timer counts whole seconds, and not every number is one [s].
constexpr double longest_time_limit = 1e9;

struct RunOptions {
  std::filesystem::path scene, flow, out;
  std::optional<std::string> seeds;
  std::string tolerance, time_limit, until;
  Overrides overrides;
  std::vector<std::string> sweeps;
};

/// One point of the sweep; the only one, if there is none.
struct Prepared {
  SweepPoint point;
  Scene scene;
  std::shared_ptr<const FlowGrid> flow;
  std::string note;
  double cost = 0;
};

/// The flow as this scene wants it; `file` as it was read, shared by the points that want it so.
std::shared_ptr<const FlowGrid> flow_for(Prepared& prepared, const RunOptions& options,
                                         std::shared_ptr<const FlowGrid>& file) {
  if (prepared.scene.flow.source != FlowSource::openfoam) {
    require(options.flow.empty(), "{}: flow.source is not \"openfoam\", so {} would not be used: leave out --flow",
            options.scene.string(), options.flow.string());
    return {};
  }
  require(!options.flow.empty(),
          "{}: flow.source = \"openfoam\" needs the flow: give --flow flow.h5 (clog case, its "
          "Allrun and clog map make it)",
          options.scene.string());
  if (!file) file = std::make_shared<const FlowGrid>(read_flow_grid(options.flow));
  if (!prepared.scene.flow.rescale) return file;
  RescaledFlow rescaled = rescaled_flow(*file, prepared.scene);
  if (!prepared.note.empty()) prepared.note += "\n";
  prepared.note += fmt::format(
      "the flow is scaled by {:.6g}; that leaves out {:.2g} % of the "
      "neck's mean velocity at most",
      rescaled.factor, 100 * rescaled.error);
  return std::make_shared<const FlowGrid>(std::move(rescaled.grid));
}

Prepared prepare(const RunOptions& options, const SweepPoint& point, std::shared_ptr<const FlowGrid>& file) {
  Overrides overrides = options.overrides;
  overrides.insert(overrides.end(), point.overrides.begin(), point.overrides.end());
  auto [scene, fidelity] = trade::read_resolved_scene(options.scene, overrides);
  Prepared prepared{point, std::move(scene), {}, fidelity};
  if (options.seeds) prepared.scene.ensemble.seeds = parse_seeds(*options.seeds);
  prepared.flow = flow_for(prepared, options, file);
  // What is wrong with the scene is wrong for every seed: say it once, before any run begins.
  const std::vector<Particle> initial = read_initial_particles(prepared.scene);
  const Model model = make_model(prepared.scene, prepared.flow.get(), initial);
  check_step(expected_limits(model, initial), model);
  prepared.cost = make_plan(prepared.scene).seconds();
  return prepared;
}

std::vector<Prepared> prepare_points(const RunOptions& options) {
  // The command line replaces the sweep of the scene.
  const auto sweeps = options.sweeps.empty()
                          ? trade::read_resolved_scene(options.scene, options.overrides).scene.ensemble.sweep
                          : options.sweeps;
  std::vector<Prepared> all;
  std::shared_ptr<const FlowGrid> file;
  for (const SweepPoint& point : sweep_points(sweeps)) {
    try {
      all.push_back(prepare(options, point, file));
    } catch (const Error& error) {
      throw Error(point.folder.empty() ? error.what() : fmt::format("{}: {}", point.folder, error.what()));
    }
  }
  return all;
}

/// Rank 0 speaks for all ranks that meet the same problem, and its end ends them; one that is alone with its
/// problem says so.
template <class Work>
auto on_every_rank(const Launch& launch, const Work& work) {
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
  const Quantity quantity = parse_quantity(limit);
  require(quantity.dimension == dimension::time && quantity.si > 0 && quantity.si < longest_time_limit,
          "--time-limit {} (must be a positive time below {:.0g} s, such as '55 min')", limit, longest_time_limit);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(quantity.si);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (quantity.si - std::floor(quantity.si)));
  if (timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0) timer.it_value.tv_usec = 1;
  require(::setitimer(ITIMER_REAL, &timer, nullptr) == 0, "--time-limit {} (the system has no such timer)", limit);
}

void say(const SeedReport& report) {
  const bool aside = report.failed || report.note;
  put(aside ? stderr : stdout, fmt::format("{}{}seed {}: {}\n", aside ? "clog: " : "",
                                           report.point.empty() ? "" : report.point + ", ", report.seed, report.line));
}

EnsembleCall call_for(const std::vector<Prepared>& points, const RunOptions& options, const Launch& launch) {
  EnsembleCall call{{}, launch, options.out / "ensemble.csv"};
  for (const Prepared& p : points) {
    if (launch.rank == 0 && !p.note.empty())
      fmt::print("{}{}\n", p.point.folder.empty() ? "" : p.point.folder + ": ", p.note);
    call.ensembles.push_back(
        {p.scene, p.flow.get(), options.out / p.point.folder, &stop_asked, p.point.folder, p.cost});
  }
  return call;
}

/// One decision an ensemble, or none.
std::vector<std::shared_ptr<EnoughSeeds>> decide_by(const std::string& until, EnsembleCall& call) {
  std::vector<std::shared_ptr<EnoughSeeds>> decisions;
  if (until.empty()) return decisions;
  const postprocess::StoppingRule rule(until);
  for (Ensemble& ensemble : call.ensembles) {
    decisions.push_back(std::make_shared<EnoughSeeds>(rule, ensemble));
    ensemble.wanted = [decision = decisions.back()](std::uint64_t seed) { return decision->wanted(seed); };
  }
  return decisions;
}

/// What was decided. \throws Error if more seeds are needed than were allowed
void say(const std::vector<std::shared_ptr<EnoughSeeds>>& decisions, const EnsembleCall& call) {
  std::vector<std::string> not_met;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    const std::string& point = call.ensembles[i].name;
    const std::string line = (point.empty() ? "" : point + ": ") + decisions[i]->summary();
    decisions[i]->is_met() ? fmt::print("{}\n", line) : not_met.push_back(line);
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
    fmt::print("{} ranks, busy {:.1f} % of {:.1f} s\n", call.launch.count,
               100 * result.busy / (result.duration * call.launch.count), result.duration);
  if (result.left_to_others > 0)
    fmt::print("{} of {} seeds are left to other calls that are at work on them, such as {}\n", result.left_to_others,
               seeds, result.other);
  require(result.failed == 0, "{} of {} seeds failed; the others are in {}", result.failed, seeds, out.string());
  require(result.unrecorded == 0, "{} seeds are done but not listed in {}", result.unrecorded, call.ledger.string());
}

void run(const RunOptions& options) {
  stop_at({SIGTERM, SIGINT, SIGALRM});
  if (!options.time_limit.empty()) stop_after(options.time_limit);
  const Launch launch = launch_from_environment();
  const auto points = on_every_rank(launch, [&] {
    select_kernels();  // says what is wrong with CLOG_ISA
    return prepare_points(options);
  });
  EnsembleCall call = call_for(points, options, launch);
  for (const std::string& line : on_every_rank(launch, [&] { return check_directories(call); }))
    if (launch.rank == 0) put(stderr, fmt::format("clog: {}\n", line));
  const auto decisions = on_every_rank(launch, [&] { return decide_by(options.until, call); });
  ProgressLine line(launch.rank == 0 && isatty(STDERR_FILENO));
  const EnsembleResult result = run_ensembles(
      call, [&](const Progress& progress) { line.show(progress); },
      [&](const SeedReport& report) {
        line.clear();
        say(report);
      });
  for (const auto& decision : decisions) decision->settle();
  conclude(call, result, options.out);
  if (launch.rank == 0) say(decisions, call);
  // Not for ranks: launchers kill all when one ends otherwise, and may meet the others at saving their states.
  if (!result.complete && !launch.by_launcher && (stop_signal == SIGINT || stop_signal == SIGTERM))
    throw EndWithStatus{128 + stop_signal};
}

}  // namespace

void add_run(CLI::App& app) {
  auto* verb = app.add_subcommand("run", "push the particles through: one file per seed");
  auto options = std::make_shared<RunOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--flow", options->flow, "flow.h5 made by clog map");
  verb->add_option("--seeds", options->seeds, "for example 1-40; default: ensemble.seeds");
  verb->add_option("--sweep", options->sweeps, "key=value,value: a folder for every value; again for every key")
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
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->callback([options] {
    if (!options->tolerance.empty()) options->overrides.push_back("fidelity.tolerance=" + options->tolerance);
    run(*options);
  });
}

}  // namespace clogflow::cli
