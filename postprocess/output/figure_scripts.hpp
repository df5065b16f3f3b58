// The python scripts of postprocess/figures, which draw.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clogflow::postprocess {

/// Runs a script. The interpreter is /usr/bin/python3, where Debian's matplotlib is, unless CLOG_PYTHON names
/// another; the scripts are those of the source tree unless CLOG_FIGURES names another folder. Each file gets its name
/// in `out` when it is whole.
/// \param from  what the script reads
/// \param job   for a script that reads more than that: a text, put into a file that the script is given as `from`
/// \param more  words that the script is given behind these
/// \return the files that it wrote, in its order
/// \throws Error when python, a module or a script is missing, or the script fails (its last line)
std::vector<std::filesystem::path> run_figure_script(const std::string& name, std::filesystem::path from,
                                                     const std::filesystem::path& out, const std::string& job = "",
                                                     const std::vector<std::string>& more = {});

/// A variable of the environment, or another text where it is not set.
std::string of_environment(const char* variable, const std::string& otherwise);

}  // namespace clogflow::postprocess
