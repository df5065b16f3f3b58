// The program `clog`: finds the verb, and turns every refusal into one line on standard error.

#include <csignal>
#include <cstdio>
#include <exception>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/require.hpp"

int main(int argc, char** argv) {
  // A limit on the size of files is then an error of the write, with a line, and not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app{"clogflow: clogging of suspensions, from the flow field to the statistics", "clog"};
  app.require_subcommand(1);
  app.set_version_flag("--version", CLOG_VERSION);
  clog::cli::add_plan(app);
  clog::cli::add_case(app);
  clog::cli::add_walls(app);
  clog::cli::add_map(app);
  clog::cli::add_run(app);
  clog::cli::add_fit(app);
  clog::cli::add_stats(app);
  clog::cli::add_report(app);
  clog::cli::add_trade(app);
  clog::cli::add_info(app);
  try {
    app.parse(argc, argv);
    clog::require(std::fflush(stdout) == 0 && !std::ferror(stdout),
                  "standard output cannot be written (disk full?): what was said is lost, files are not");
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    // An empty text: another rank of the same job has said it.
    if (*error.what()) clog::cli::put(stderr, fmt::format("clog: {}\n", clog::Error(error.what()).what()));
    return 1;
  }
}
