// clog run: the particles, for every seed asked for.

#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/progress.hpp"
#include "cli/verbs.hpp"
#include "coupling/flow_rescale.hpp"
#include "coupling/require.hpp"
#include "dem/ensemble.hpp"
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
};

struct Prepared {
  Scene scene;
  std::optional<FlowGrid> flow;
  std::string note;
};

Prepared prepare(const RunOptions& options) {
  auto [scene, fidelity] = trade::read_resolved_scene(options.scene, options.overrides);
  Prepared prepared{std::move(scene), {}, fidelity};
  if (!options.seeds.empty()) prepared.scene.ensemble.seeds = parse_seeds(options.seeds);
  if (prepared.scene.flow.source == FlowSource::openfoam) {
    require(!options.flow.empty(),
            "{}: flow.source = \"openfoam\" needs the flow: give --flow flow.h5 (clog case, its "
            "Allrun and clog map make it)",
            options.scene.string());
    prepared.flow = read_flow_grid(options.flow);
    if (prepared.scene.flow.rescale) {
      RescaledFlow rescaled = rescaled_flow(std::move(*prepared.flow), prepared.scene);
      if (!prepared.note.empty()) prepared.note += "\n";
      prepared.note += fmt::format("the flow is scaled by {:.6g}; that leaves out {:.2g} % of the "
                                  "neck's mean velocity at most",
                                  rescaled.factor, 100 * rescaled.error);
      prepared.flow = std::move(rescaled.grid);
    }
  }
  // What is wrong with the scene is wrong for every seed: say it once, before any run begins.
  const std::vector<Particle> initial = read_initial_particles(prepared.scene);
  const Model model =
      make_model(prepared.scene, prepared.flow ? &*prepared.flow : nullptr, initial);
  check_step(expected_limits(model, initial), model);
  return prepared;
}

/// Prepares on every rank; of several ranks that fail, the first speaks for all.
Prepared prepare_together(const RunOptions& options, Ranks& ranks) {
  std::string problem;
  Prepared prepared;
  try {
    prepared = prepare(options);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  const int speaker = ranks.least(problem.empty() ? ranks.count() : ranks.rank());
  if (speaker == ranks.count()) return prepared;
  throw Error(speaker == ranks.rank() ? problem : "");
}

void run(const RunOptions& options) {
  Ranks ranks;
  const Prepared prepared = prepare_together(options, ranks);
  if (ranks.rank() == 0 && !prepared.note.empty()) fmt::print("{}\n", prepared.note);
  std::signal(SIGTERM, [](int) { stop_asked = true; });
  std::signal(SIGINT, [](int) { stop_asked = true; });
  const Ensemble ensemble{prepared.scene, prepared.flow ? &*prepared.flow : nullptr, options.out,
                          &stop_asked};
  ProgressLine line(ranks.rank() == 0 && isatty(STDERR_FILENO));
  const EnsembleResult result = run_ensemble(
      ensemble, ranks, [&](const Progress& progress) { line.show(progress); },
      [&](const SeedReport& report) {
        line.clear();
        const bool aside = report.failed || report.note;
        fmt::print(aside ? stderr : stdout, "{}seed {}: {}\n", aside ? "clog: " : "", report.seed,
                   report.line);
        std::fflush(stdout);
      });
  if (result.failed == 0) return;
  throw Error(ranks.rank() != 0 ? ""
                                : fmt::format("{} of {} seeds failed; the others are in {}", result.failed,
                                              prepared.scene.ensemble.seeds.size(),
                                              options.out.string()));
}

}  // namespace

void add_run(CLI::App& app) {
  auto* verb = app.add_subcommand("run", "push the particles through: one file per seed");
  auto options = std::make_shared<RunOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--flow", options->flow, "flow.h5 made by clog map");
  verb->add_option("--seeds", options->seeds, "for example 1-40; default: ensemble.seeds");
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
