// The command line as a manual page and as rules for the shell, both made from the verbs and options that the program
// itself parses, and from the key table.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace clogflow::cli {

/// In the order in which they were added.
std::vector<const CLI::App*> verbs_of(const CLI::App& app);

/// The page clogflow.1, for `man`.
std::string man_page(const CLI::App& app);

/// Completion of verbs, options, scene keys after --set and --sweep, and the words that a key may be; for bash, and for
/// zsh through its bashcompinit.
/// \param shell "bash" or "zsh"
std::string shell_completion(const CLI::App& app, const std::string& shell);

}  // namespace clogflow::cli
