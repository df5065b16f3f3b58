// clog run: the particles, for every seed asked for.

#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/progress.hpp"
#include "cli/verbs.hpp"
#include "coupling/flow_rescale.hpp"
#include "coupling/require.hpp"
#include "coupling/sweep.hpp"
#include "dem/ensemble.hpp"
#include "dem/plan.hpp"
#include "dem/step_limit.hpp"
#include "trade/fidelity.hpp"

namespace clog::cli {
namespace {

/// Set by SIGTERM and SIGINT: the runs save their states and end. A lock-free atomic is all that a signal
/// handler may touch.
std::atomic<bool> stop_asked = false;

struct RunOptions {
  std::filesystem::path scene, flow, out;
  std::string seeds, tolerance;
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
  if (prepared.scene.flow.source != FlowSource::openfoam) return {};
  require(!options.flow.empty(),
          "{}: flow.source = \"openfoam\" needs the flow: give --flow flow.h5 (clog case, its "
          "Allrun and clog map make it)",
          options.scene.string());
  if (!file) file = std::make_shared<const FlowGrid>(read_flow_grid(options.flow));
  if (!prepared.scene.flow.rescale) return file;
  RescaledFlow rescaled = rescaled_flow(*file, prepared.scene);
  if (!prepared.note.empty()) prepared.note += "\n";
  prepared.note += fmt::format("the flow is scaled by {:.6g}; that leaves out {:.2g} % of the "
                              "neck's mean velocity at most",
                              rescaled.factor, 100 * rescaled.error);
  return std::make_shared<const FlowGrid>(std::move(rescaled.grid));
}

Prepared prepare(const RunOptions& options, const SweepPoint& point, std::shared_ptr<const FlowGrid>& file) {
  Overrides overrides = options.overrides;
  overrides.insert(overrides.end(), point.overrides.begin(), point.overrides.end());
  auto [scene, fidelity] = trade::read_resolved_scene(options.scene, overrides);
  Prepared prepared{point, std::move(scene), {}, fidelity};
  if (!options.seeds.empty()) prepared.scene.ensemble.seeds = parse_seeds(options.seeds);
  prepared.flow = flow_for(prepared, options, file);
  // What is wrong with the scene is wrong for every seed: say it once, before any run begins.
  const std::vector<Particle> initial = read_initial_particles(prepared.scene);
  const Model model = make_model(prepared.scene, prepared.flow.get(), initial);
  check_step(expected_limits(model, initial), model);
  prepared.cost = make_plan(prepared.scene).seconds;
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

/// Prepares on every rank; of several ranks that fail, the first speaks for all.
std::vector<Prepared> prepare_together(const RunOptions& options, Ranks& ranks) {
  std::string problem;
  std::vector<Prepared> prepared;
  try {
    prepared = prepare_points(options);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  const int speaker = ranks.least(problem.empty() ? ranks.count() : ranks.rank());
  if (speaker == ranks.count()) return prepared;
  throw Error(speaker == ranks.rank() ? problem : "");
}

void say(const SeedReport& report) {
  const bool aside = report.failed || report.note;
  fmt::print(aside ? stderr : stdout, "{}{}seed {}: {}\n", aside ? "clog: " : "",
             report.point.empty() ? "" : report.point + ", ", report.seed, report.line);
  std::fflush(stdout);
}

void run(const RunOptions& options) {
  Ranks ranks;
  std::signal(SIGTERM, [](int) { stop_asked = true; });
  std::signal(SIGINT, [](int) { stop_asked = true; });
  const std::vector<Prepared> points = prepare_together(options, ranks);
  std::vector<Ensemble> ensembles;
  std::size_t seeds = 0;
  for (const Prepared& p : points) {
    if (ranks.rank() == 0 && !p.note.empty())
      fmt::print("{}{}\n", p.point.folder.empty() ? "" : p.point.folder + ": ", p.note);
    ensembles.push_back(
        {p.scene, p.flow.get(), options.out / p.point.folder, &stop_asked, p.point.folder, p.cost});
    seeds += p.scene.ensemble.seeds.size();
  }
  ProgressLine line(ranks.rank() == 0 && isatty(STDERR_FILENO));
  const EnsembleResult result = run_ensembles(
      ensembles, ranks, [&](const Progress& progress) { line.show(progress); },
      [&](const SeedReport& report) {
        line.clear();
        say(report);
      });
  if (result.failed == 0) return;
  throw Error(ranks.rank() != 0 ? ""
                                : fmt::format("{} of {} seeds failed; the others are in {}", result.failed,
                                              seeds, options.out.string()));
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
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->callback([options] {
    if (!options->tolerance.empty())
      options->overrides.push_back("fidelity.tolerance=" + options->tolerance);
    run(*options);
  });
}

}  // namespace clog::cli
