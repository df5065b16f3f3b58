// The program `clog`: finds the verb, and turns every refusal into one line on standard error.

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/nearest_word.hpp"
#include "coupling/base/require.hpp"

namespace {

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

}  // namespace

int main(int argc, char** argv) {
  // A limit on the size of files is then an error of the write, with a line, and not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app{"clogflow: clogging of suspensions, from the flow field to the statistics", "clog"};
  app.require_subcommand(1);
  app.set_version_flag("--version", CLOG_VERSION);
  clogflow::cli::add_plan(app);
  clogflow::cli::add_case(app);
  clogflow::cli::add_walls(app);
  clogflow::cli::add_map(app);
  clogflow::cli::add_run(app);
  clogflow::cli::add_fit(app);
  clogflow::cli::add_stats(app);
  clogflow::cli::add_report(app);
  clogflow::cli::add_film(app);
  clogflow::cli::add_trade(app);
  clogflow::cli::add_pack(app);
  clogflow::cli::add_info(app);
  clogflow::cli::add_export(app);
  clogflow::cli::add_keys(app);
  try {
    check_verb(app, argc, argv);
    app.parse(argc, argv);
    clogflow::require(std::fflush(stdout) == 0 && !std::ferror(stdout),
                      "standard output cannot be written (disk full?): what was said is lost, files are not");
    return 0;
  } catch (const clogflow::cli::EndWithStatus& end) {
    return end.status;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    // An empty text: another rank of the same job has said it.
    if (*error.what()) clogflow::cli::put(stderr, fmt::format("clog: {}\n", clogflow::Error(error.what()).what()));
    return 1;
  }
}
