// One function per verb of `clog`: it adds its subcommand, options and callback.
#pragma once

#include <CLI/CLI.hpp>

namespace clogflow::cli {

/// Ends the program with a status that is no failure and not done either; what there is to say was said.
struct EndWithStatus {
  int status;
};

void add_plan(CLI::App& app);
void add_case(CLI::App& app);
void add_map(CLI::App& app);
void add_walls(CLI::App& app);
void add_run(CLI::App& app);
void add_stats(CLI::App& app);
void add_fit(CLI::App& app);
void add_report(CLI::App& app);
void add_film(CLI::App& app);
void add_trade(CLI::App& app);
void add_pack(CLI::App& app);
void add_info(CLI::App& app);
void add_export(CLI::App& app);
void add_keys(CLI::App& app);

}  // namespace clogflow::cli
