// The program `clog`: finds the verb, and turns every refusal into one line on standard error.

#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/nearest_word.hpp"
#include "coupling/base/require.hpp"

namespace {

/// The other verbs have no results to read by a program, or, as `fit`, print JSON alone.
constexpr std::array<std::string_view, 3> verbs_with_json{"plan", "info", "stats"};

/// The library would call it an argument that was not expected. \throws CLI::ParseError
void check_verb(const CLI::App& app, int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  if (verb.empty() || verb.starts_with('-')) return;
  std::string nearest, all;
  std::size_t least = verb.size();
  for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string& name = known->get_name();
    if (name == verb) return;
    all += (all.empty() ? "" : ", ") + name;
    const std::size_t distance = clogflow::edit_distance(verb, name);
    if (distance < least && clogflow::is_near(distance, verb)) least = distance, nearest = name;
  }
  throw CLI::ParseError(nearest.empty() ? fmt::format("no verb \"{}\": known are {}", verb, all)
                                        : fmt::format("no verb \"{}\": is \"{}\" meant?", verb, nearest),
                        CLI::ExitCodes::ExtrasError);
}

/// Every verb has them, and is told of them in its own help.
void add_output_options(CLI::App& app, int argc, char** argv) {
  const auto options = std::make_shared<clogflow::cli::OutputOptions>();
  std::string call = app.get_name();
  for (int i = 1; i < argc; ++i) call += std::string(" ") + argv[i];
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    verb->add_flag("--quiet", options->quiet, "say nothing but results and errors");
    verb->add_option("--log", options->log, "file to add everything to that is said, each line with its time");
    if (std::ranges::find(verbs_with_json, verb->get_name()) != verbs_with_json.end())
      verb->add_flag("--json", options->json, "the results as JSON, and nothing else, on standard output");
    verb->parse_complete_callback(
        [options, call] { clogflow::cli::begin_output(*options, fmt::format("clogflow {}: {}", CLOG_VERSION, call)); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace clogflow::cli;
  // A limit on the size of files is then an error of the write, with a line, and not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  set_program_name(argc > 0 ? argv[0] : "");
  CLI::App app{"clogflow: clogging of suspensions, from the flow field to the statistics", program_name()};
  app.require_subcommand(1);
  app.set_version_flag("--version", CLOG_VERSION);
  add_plan(app);
  add_case(app);
  add_walls(app);
  add_map(app);
  add_run(app);
  add_fit(app);
  add_stats(app);
  add_report(app);
  add_film(app);
  add_trade(app);
  add_pack(app);
  add_info(app);
  add_export(app);
  add_keys(app);
  add_output_options(app, argc, argv);
  try {
    check_verb(app, argc, argv);
    app.parse(argc, argv);
    end_output();
    return 0;
  } catch (const EndWithStatus& end) {
    return end.status;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    // An empty text: another rank of the same job has said it.
    if (*error.what()) print_error(clogflow::Error(error.what()).what());
    return 1;
  }
}
