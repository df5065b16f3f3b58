// clog trade: cost against error, measured.

#include <filesystem>
#include <memory>
#include <optional>

#include "cli/output.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "ensemble/shared_flow.hpp"
#include "postprocess/output/report.hpp"
#include "trade/study_file.hpp"

namespace clogflow::cli {
namespace {

namespace fs = std::filesystem;

struct TradeOptions {
  fs::path scene, flow, out, step_from;
  std::string budget = "10 min";
  std::vector<fs::path> combine;
  std::vector<std::string> settings;
  Overrides overrides;
};

double budget_seconds(const std::string& text) {
  constexpr const char* meaning = "a time such as '45 min', 0 s to evaluate what is there";
  const double seconds = parse_option("--budget", text, dimension::time, meaning);
  require(seconds >= 0, "--budget {} (must be {})", text, meaning);
  return seconds;
}

void combine_studies(const TradeOptions& options) {
  std::vector<trade::MeasuredStudy> studies;
  for (const fs::path& file : options.combine) studies.push_back(trade::read_study(file));
  publish_file(trade::measured_text(studies), options.out);
}

void run_on(const TradeOptions& options, Ranks& ranks) {
  trade::Study study{options.scene, options.overrides, nullptr, options.out, budget_seconds(options.budget),
                     &stop_asked,   options.settings};
  if (!options.step_from.empty())
    study.step_slopes = trade::read_step_slopes(options.step_from, read_scene(options.scene, options.overrides));
  FlowGrid flow;
  ranks.together([&] {
    if (ranks.is_first() && !options.flow.empty()) flow = read_flow_grid(options.flow);
    trade::check_study(study);
  });
  if (!options.flow.empty()) study.flow = &(flow = shared_flow(flow, ranks));
  ranks.together([&] { trade::check_runs(study); });
  trade::run_study(study, ranks, [](const std::string& line) { print_words("{}\n", line); });
  ranks.part();
  if (!ranks.is_first()) return;
  const trade::StudyResults results = trade::study_results(study);
  publish_file(trade::study_text(results), options.out / "trade.json");
  const std::string table = trade::table(results);
  publish_file(table, options.out / "trade.txt");
  print_result("{}", table);
  for (const fs::path& file : postprocess::make_trade_figure(options.out / "trade.json", options.out))
    print_result("{}\n", file.string());
}

void run(const TradeOptions& options) {
  if (!options.combine.empty()) return combine_studies(options);
  require(!options.scene.empty(), "clog trade needs a scene, or --combine");
  stop_at({SIGTERM, SIGINT});
  Ranks ranks;
  ranks.run([&] { run_on(options, ranks); });
}

}  // namespace

void add_trade(CLI::App& app) {
  auto* verb = app.add_subcommand("trade", "measure speed against accuracy");
  auto options = std::make_shared<TradeOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)");
  verb->add_option("--flow", options->flow, "flow.h5 made by clog map");
  verb->add_option("--out", options->out, "folder of the study; with --combine the file to write")->required();
  verb->add_option("--budget", options->budget, "wall-clock time for runs; finished ones are kept")
      ->capture_default_str();
  verb->add_option("--combine", options->combine, "trade.json of several studies: the presets of all");
  verb->add_option("--settings", options->settings, "run these settings only, by name; all that ran are evaluated");
  verb->add_option("--step-from", options->step_from,
                   "trade.json of another diameter, whose response to the step counts as a measurement here");
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->callback([options] { run(*options); });
}

}  // namespace clogflow::cli
